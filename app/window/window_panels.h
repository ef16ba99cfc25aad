// Draws everything over the picture, once a frame: panels and plots, dialogs, hints, notices and the message. Owns the
// user settings that they change.
#pragma once
#include <filesystem>
#include <vector>

#include "app/dialogs/file_dialogs.h"
#include "app/dialogs/gallery.h"
#include "app/panels/hints.h"
#include "app/window/capture_control.h"
#include "app/window/recovery.h"

namespace fascia {

class WindowPanels {
 public:
  /// With `scripted` the window does not change the user's settings and gives no hints.
  WindowPanels(Stage& stage, Sides& sides, const CaptureControl& capture, const Recovery& recovery,
               const std::filesystem::path& data_dir, bool scripted);

  /// The first scene is open. With `greet` a new user sees the examples.
  void begin(bool greet);
  void opened(const std::filesystem::path& path) { dialogs_.opened(path); }
  void ask(const Requests& requests);  // requested dialogs open in the next frame
  void draw(Requests& requests);       // between ImGui::NewFrame and ImGui::Render

 private:
  void follow_hints();

  Stage& stage_;
  Sides& sides_;
  const CaptureControl& capture_;
  const Recovery& recovery_;
  bool scripted_;
  UserStore user_;
  FileDialogs dialogs_;
  Gallery gallery_;
  Hints hints_;
  std::vector<Material> tuned_from_;  // materials of the last frame, while the hint about them is shown
};

}  // namespace fascia
