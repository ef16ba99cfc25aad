// Asks where a file is to go: a name, and the folders to put it in. A file that is there already is replaced only after
// a question.
#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/dialogs/folder_browser.h"

namespace fascia {

class SaveDialog {
 public:
  struct Format {
    std::string ending, help;
  };
  using Shipped = std::function<bool(const std::filesystem::path&)>;  // whether a file came with fascia
  struct Option {
    std::string label, help;  // no label: there is none
  };
  /// Of several formats one is chosen by the ending of the name; a name without one gets the first. `option`: a box to
  /// tick, off at first.
  SaveDialog(const char* title, std::vector<Format> formats, Option option = {});

  /// Opens with this name, at first in the working folder, then in the folder that was saved to last.
  void ask(const std::string& name);
  /// Between ImGui::NewFrame and ImGui::Render. `places`: beside the usual ones.
  std::optional<std::filesystem::path> draw(const std::vector<Place>& places, const Shipped& shipped);
  bool option() const { return option_on_; }  // whether the box is ticked

 private:
  void go_to(const std::filesystem::path& folder);
  void choose();
  void choose_format();
  void question(const Shipped& shipped);
  bool known(const std::string& ending) const;

  const char* title_;
  std::vector<Format> formats_;
  Option option_;
  bool option_on_ = false;
  FileKind kind_;
  FolderBrowser browser_;
  std::string name_, walked_from_;  // the name that the arrow keys left
  std::string warning_;
  std::filesystem::path target_;
  enum class Stage { closed, asked, open, questioned, done } stage_ = Stage::closed;
  bool focus_ = false;
};

}  // namespace fascia
