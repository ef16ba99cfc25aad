// Changes to the open scene that are more than a slider: taking them back, regions with a material of their own,
// another unit, and the command line that brings them all back.
#pragma once
#include <optional>
#include <vector>

#include "app/session/open_input.h"
#include "app/window/recording_control.h"

namespace fascia {

class TuningHistory {
 public:
  TuningHistory(Stage& stage, Sides& sides, RecordingControl& recording)
      : stage_(stage), sides_(sides), recording_(recording) {}

  void session_began();
  void follow();                    // once a frame, after the panels: what was turned becomes an entry
  void go_to(std::size_t entries);  // until so many are in force. Throws Error
  /// Throws Error and changes nothing where an entry names no region.
  void set_materials(const std::vector<MaterialEntries>& entries);
  /// The scene as it is now, with all lengths times `factor`, to be opened anew.
  Opened rescaled(double factor) const;
  void copy_command() const;  // to the clipboard

 private:
  void materials_changed();
  Scene scene_to_reproduce() const;

  Stage& stage_;
  Sides& sides_;
  RecordingControl& recording_;
  std::optional<CameraSettings> opened_camera_;  // as the session began with
};

}  // namespace fascia
