// A gallery of the shipped scenes, which open with one click: a strip at the bottom of the picture, so that the tissue
// stays in view.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "app/state/window_state.h"
#include "gl/texture.h"

namespace fascia {

struct Example {
  std::filesystem::path scene, picture;
  std::string name, title, says;  // name: a word or two
};

/// Scenes of assets/scenes: in the order of assets/gallery.json, which also describes them, then those that it does not
/// name. Unreadable ones are left out.
std::vector<Example> shipped_examples(const std::filesystem::path& assets);

class Gallery {
 public:
  explicit Gallery(const std::filesystem::path& data_dir) : assets_(data_dir / "assets") {}
  /// Call in every frame between ImGui::NewFrame and ImGui::Render; needs a current context. The strip begins at `left`
  /// [pixels]. True once, when it was closed, with or without a selection.
  bool draw(WindowState& state, float left, Requests& requests);

 private:
  void load();
  void draw_example(std::size_t index, WindowState& state, Requests& requests) const;

  std::filesystem::path assets_;
  bool open_ = false;
  std::vector<Example> examples_;
  std::vector<gl::Texture> pictures_;  // of the examples, while open; empty without a picture
};

}  // namespace fascia
