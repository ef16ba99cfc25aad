// Changes to the open scene beyond a single slider: undo, materials of single regions, fixed vertices, painted regions,
// elements, other units of length, and the command line that reproduces all changes.
#pragma once
#include <optional>
#include <vector>

#include "app/session/open_input.h"
#include "app/window/parts/kernel_switch.h"
#include "app/window/recording_control.h"

namespace fascia {

class TuningHistory {
 public:
  TuningHistory(Graphics& graphics, Stage& stage, Sides& sides, RecordingControl& recording, KernelSwitch& kernels)
      : graphics_(graphics), stage_(stage), sides_(sides), recording_(recording), kernels_(kernels) {}

  void session_began();
  void follow();                    // once a frame, after the panels: a changed value becomes an entry
  void go_to(std::size_t entries);  // undoes or redoes until `entries` are in force. Throws Error
  /// Throws Error and changes nothing if an entry names no region.
  void set_materials(const std::vector<MaterialEntries>& entries);
  void set_values(const std::vector<Estimate>& found);  // of materials, as a fit found them. Throws Error
  /// Throws Error, and changes nothing, during a comparison and if the scene cannot be built.
  void set_fixed(const FixedSets& fixed);
  void set_painting(const Painting& painting);                       // as set_fixed
  void set_elements(const ElementOrders& elements);                  // as well
  void set_instruments(const std::vector<Instrument>& instruments);  // as well
  /// The current scene with all lengths times `factor`, to be opened as a new session.
  Opened rescaled(double factor) const;
  void copy_command() const;  // to the clipboard

 private:
  void rebuild(const Tunables& wanted);
  void materials_changed();
  void model_changed();
  Scene scene_to_reproduce() const;

  Graphics& graphics_;
  Stage& stage_;
  Sides& sides_;
  RecordingControl& recording_;
  KernelSwitch& kernels_;
  std::optional<CameraSettings> opened_camera_;  // at the start of the session
};

}  // namespace fascia
