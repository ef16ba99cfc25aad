// What the window knows beside the session, shared by its loop, its keys and its panels; and what keys and panels ask
// of it.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/session/advice.h"
#include "app/state/convergence.h"
#include "app/state/plots.h"
#include "app/state/undo_history.h"
#include "app/ui/recent_values.h"
#include "app/video/video_settings.h"
#include "sim/gpu/readback/diagnostics.h"
#include "sim/grab/interactive_grab.h"
#include "sim/simulation/scene_edits.h"

namespace fascia {

struct Statistics {
  bool measured = false;  // false: a headless picture, which must not depend on a clock
  /// Of so many steps, as the GPU measured them together [ms]; `compiled`: kernels, too, which says nothing about the
  /// next steps. Adds the time of each to `all`, from which stats.json is made.
  void add_steps(double milliseconds, int count, bool compiled, std::vector<double>& all);

  RecentValues frame, solve, render;  // [ms]; solve: one time step
  double step_ms = 0;                 // one step, averaged with fading weights: what the next one may take
  double speed = 1;                   // simulated over real time
  bool keeps_pace = true;
  double waits = 0;  // for a solver that cannot step yet [s]
  long steps = 0;
  std::optional<Diagnostics> diagnostics;
};

/// What of a model does not change while it is simulated, for the panels.
struct SceneFacts {
  SceneFacts() = default;
  SceneFacts(const Scene& scene, const Model& model);
  double mass(const Model& model) const;  // [kg], at the densities of now

  struct Region {
    std::size_t body;
    int number;         // in the mesh
    std::string key;    // in the scene's "materials"
    std::string label;  // for people
    double volume;      // [m^3]
    std::uint32_t material;
  };
  std::vector<Region> regions;              // that have tets, body by body, ascending numbers
  double volume = 0;                        // of all [m^3]
  std::optional<UnitHint> unit;             // where the size is no tissue's
  std::vector<double> material_volume;      // [material_count] [m^3]
  std::vector<std::string> material_names;  // without the body's name where there is only one body
};

/// What is asked of a comparison of two settings side by side.
enum class CompareAsk { nothing, open_or_close, edit_a, edit_b, copy_a, swap, keep_b };

struct WindowState {
  bool paused = false, show_panels = true, show_help = false, recording = false;
  bool show_convergence = false;  // measured only while it is shown
  Convergence convergence;
  Plots plots;
  GrabSettings grab;
  std::size_t grabs = 0;  // of the user, on the tissue
  SceneFacts facts;
  std::size_t chosen_material = 0;  // whose sliders are shown
  HintBoard hints;
  UndoHistory history;
  bool comparing = false, editing_b = false;  // the panels show side B
  Statistics statistics;
  bool show_recording = false;
  VideoSettings video;
  double replay_speed = 1;    // of a replay that plays, over real time
  bool replay_camera = true;  // look where its user looked
};

/// Asked during a frame, carried out between frames.
struct Requests {
  bool open_dialog = false, save_dialog = false, reset = false, step = false, frame_view = false, screenshot = false,
       video = false, reload_shaders = false, close = false, plot_table = false, plot_picture = false, recent = false,
       export_dialog = false, gallery = false, copy_command = false, resume_recovered = false, forget_recovered = false,
       let_go = false, save_replay_dialog = false, end_replay = false, save_with_mesh = false;
  std::optional<std::filesystem::path> open, save, export_state, save_replay,
      resume;  // resume: what a session left (autosave.h)
  CompareAsk compare = CompareAsk::nothing;
  std::optional<std::size_t> history;                     // so many of its entries shall be in force
  std::optional<std::vector<MaterialEntries>> materials;  // regions that get a material of their own, or lose it
  std::optional<double> rescale;                          // of all bodies, by this factor: the file was in another unit
  /// Some are carried out with the steps and the picture of a frame.
  bool wait_for_picture() const { return step || screenshot || video || plot_table || plot_picture; }
};

}  // namespace fascia
