// The window's state outside the session, shared by its loop, its keys and its panels, and the requests of keys and
// panels.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/session/advice.h"
#include "app/state/brush_settings.h"
#include "app/state/convergence.h"
#include "app/state/element_orders.h"
#include "app/state/fixed_vertices.h"
#include "app/state/instrument_presets.h"
#include "app/state/painted_regions.h"
#include "app/state/plots.h"
#include "app/state/tool_readings.h"
#include "app/state/undo_history.h"
#include "app/ui/recent_values.h"
#include "app/video/video_settings.h"
#include "sim/gpu/readback/diagnostics.h"
#include "sim/grab/interactive_grab.h"
#include "sim/simulation/scene_edits.h"

namespace fascia {

struct Statistics {
  bool measured = false;  // false: a headless picture, which must not depend on a clock
  /// Adds the time of `count` steps, which the GPU measured together [ms]; `compiled`: includes compilation, so it does
  /// not predict the next steps. Appends the time of each to `all`, from which stats.json is made.
  void add_steps(double milliseconds, int count, bool compiled, std::vector<double>& all);

  RecentValues frame, solve, render;  // [ms]; solve: one time step
  double step_ms = 0;                 // one step, an average with decaying weights: the estimate for the next one
  double speed = 1;                   // simulated over real time
  bool keeps_pace = true;
  bool compiling = false;        // of faster kernels, which the window goes over to
  const char* quality = "full";  // of the picture, for the panels
  double waits = 0;              // for a solver that cannot step yet [s]
  long steps = 0;
  std::optional<Diagnostics> diagnostics;
  std::optional<double> inverted_since;  // simulated time [s]; none: all tets are upright
  void follow_inverted();                // once a frame, from `diagnostics`
};

/// Constant properties of a model, for the panels.
struct SceneFacts {
  SceneFacts() = default;
  SceneFacts(const Scene& scene, const Model& model);
  double mass(const Model& model) const;  // [kg], at the current densities

  struct Region {
    std::size_t body;
    int number;         // in the mesh
    std::string key;    // in the scene's "materials"
    std::string label;  // as displayed
    double volume;      // [m^3]
    std::uint32_t material;
  };
  std::vector<Region> regions;              // with tets, body by body, ascending numbers
  double volume = 0;                        // total [m^3]
  std::optional<UnitHint> unit;             // if the size is not that of tissue
  std::vector<double> material_volume;      // [material_count] [m^3]
  std::vector<std::string> material_names;  // without the body's name if there is only one body
};

/// What panels know of instruments.
struct InstrumentState {
  std::optional<std::size_t> picked;  // tool of the model that the mouse moves
  double gap = 0;                     // [m] the way of its farthest point to where it is commanded
  bool waits = false;                 // at tissue that is crushed
  ToolReadings readings;
};

/// A material whose law was replaced with the values of a tissue.
struct ReplacedLaw {
  std::size_t material;
  MaterialModel before;
};

/// A request to a comparison of two settings side by side.
enum class CompareAsk { nothing, open_or_close, edit_a, edit_b, copy_a, swap, keep_b };

struct WindowState {
  bool paused = false, show_panels = true, show_help = false, recording = false;
  bool show_convergence = false;  // measured only while shown
  Convergence convergence;
  Plots plots;
  GrabSettings grab;
  BrushSettings brush;
  InstrumentState instruments;
  std::size_t grabs = 0;  // number of the user's grabs
  SceneFacts facts;
  std::size_t chosen_material = 0;          // the one whose sliders are shown
  std::optional<ReplacedLaw> replaced_law;  // the last one, until another law is chosen or it is hidden
  HintBoard hints;
  UndoHistory history;
  bool comparing = false, editing_b = false;  // the panels show side B
  Statistics statistics;
  bool show_recording = false, show_gallery = false;
  float gallery_height = 0;  // of the strip at the bottom of the picture, with its margin [pixels]; 0: not shown
  VideoSettings video;
  double replay_speed = 1;    // of a replay, over real time
  bool replay_camera = true;  // use the recorded camera
};

/// Requests during a frame, executed between frames.
struct Requests {
  bool open_dialog = false, save_dialog = false, reset = false, step = false, frame_view = false, screenshot = false,
       video = false, reload_shaders = false, close = false, plot_table = false, plot_picture = false, recent = false,
       export_dialog = false, copy_command = false, resume_recovered = false, forget_recovered = false, let_go = false,
       save_replay_dialog = false, end_replay = false, save_with_mesh = false, let_go_instrument = false,
       stop_jaws = false, fit = false, end_fit = false, apply_fit = false;
  std::optional<std::filesystem::path> open, save, export_state, save_replay,
      resume;  // resume: the recording of an interrupted session (autosave.h)
  CompareAsk compare = CompareAsk::nothing;
  std::optional<std::size_t> history;                     // number of entries that shall be in effect
  std::optional<std::vector<MaterialEntries>> materials;  // for regions: a material of their own, or the default
  std::optional<FixedSets> fixed;                         // after a stroke of the brush
  std::optional<Painting> painting;                       // as well
  std::optional<ElementOrders> elements;                  // of a remedy for locking
  std::optional<std::size_t> pick_instrument;             // tool of the model
  std::optional<double> move_jaws;                        // 0: open, 1: close, until stop_jaws
  std::optional<InstrumentPreset> add_instrument;
  std::optional<std::size_t> remove_instrument;        // of the scene's
  std::optional<double> rescale;                       // factor for all bodies: the file has another unit
  std::optional<std::vector<std::string>> open_again;  // a mesh on its own, with these --set texts
  /// Some requests are executed with the steps and the picture of a frame.
  bool wait_for_picture() const { return step || screenshot || video || plot_table || plot_picture; }
};

}  // namespace fascia
