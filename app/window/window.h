// The window: a sequence of frames, each of input, panels, steps and drawing. An error in a frame becomes a message,
// and the open scene stays open. Only the loss of the device ends the window, and keeps the scene of some seconds ago.
// While nothing moves no frames are drawn: the window sleeps until an event. The window sets the order of the work.
// Each of its objects has one subject and its own state, and all objects share a Stage.
#pragma once
#include <filesystem>
#include <memory>

#include "app/cli/options.h"
#include "app/window/controls.h"
#include "app/window/parts/frame_log.h"
#include "app/window/parts/governor.h"
#include "app/window/parts/kernel_switch.h"
#include "app/window/parts/scene_opener.h"
#include "app/window/stepping.h"
#include "app/window/tuning_history.h"
#include "app/window/window_panels.h"

namespace fascia {

class Window {
 public:
  /// Throws Error if the scene cannot be simulated.
  Window(Graphics& graphics, const ViewOptions& options, Opened opened);

  /// Runs until the window is closed, the requested number of steps is made or the program is interrupted. Throws
  /// gl::ContextLost, which names the file that keeps the scene.
  void run();
  /// Completes the video that was being recorded when the window closed. Throws Error.
  void finish_video() { capture_.finish(); }

  const Simulation& simulation() const { return stage_.simulation(); }
  const RunStats& stats() const { return stepping_.stats(); }

 private:
  void wait_for_events();
  void settle();
  double idle_time() const;  // [s] until the picture can change without user input; 0 while anything moves
  void frame(double elapsed);
  void follow_kernels();
  void govern(double elapsed, const Camera& before);
  void simulate(double elapsed, bool one_step);
  void capture(const Requests& requests);
  void finish(double wall_s);

  void carry_out(const Requests& requests);
  void open(const std::filesystem::path& file);  // a scene, or measured curves for the plots
  void take_over(std::unique_ptr<Session> opened);
  void session_began();
  void set_title();
  void resume(const std::filesystem::path& file);
  void rescale(double factor);
  void open_again(const std::vector<std::string>& overrides);
  void add_instrument(InstrumentPreset preset);
  void remove_instrument(std::size_t index);
  void reset();
  void reload_shaders();

  Graphics& graphics_;
  WindowInput input_;
  Overlay overlay_;
  Stage stage_;
  Sides sides_;
  RecordingControl recording_;
  TuningHistory tuning_;
  Observer observer_;
  ScenePicture picture_;
  CaptureControl capture_;
  Recovery recovery_;
  WindowPanels panels_;
  Controls controls_;
  Stepping stepping_;
  KernelSwitch kernels_;
  SceneOpener opener_;
  FrameLog log_;
  Governor governor_;
  int frames_to_settle_;  // frames to draw although nothing moves
  bool settled_ = false;  // no event since settle()
  bool shown_ = false;    // the session was drawn in a frame: steps start after the first picture
};

}  // namespace fascia
