// The window: one frame after the other of input, panels, steps, drawing. Whatever fails in a frame becomes a message,
// and the scene that is open stays open; only the loss of the device ends it, and leaves the scene as it was some
// seconds before. While nothing moves there are no frames: the window sleeps until something happens. The window has
// the order of things; each of its objects has a subject and a state of its own, and they share a Stage.
#pragma once
#include <filesystem>
#include <memory>

#include "app/cli/options.h"
#include "app/window/controls.h"
#include "app/window/parts/kernel_switch.h"
#include "app/window/parts/scene_opener.h"
#include "app/window/stepping.h"
#include "app/window/tuning_history.h"
#include "app/window/window_panels.h"

namespace fascia {

class Window {
 public:
  /// Throws Error when the scene cannot be simulated.
  Window(Graphics& graphics, const ViewOptions& options, Opened opened);

  /// Until the window is closed, the asked number of steps is done or the program is interrupted. Throws
  /// gl::ContextLost, which names the file that keeps the scene.
  void run();
  /// The video that was being recorded when the window closed. Throws Error.
  void finish_video() { capture_.finish(); }

  const Simulation& simulation() const { return stage_.simulation(); }
  const RunStats& stats() const { return stepping_.stats(); }

 private:
  void wait_for_events();
  void settle();
  double idle_time() const;  // [s] for which nothing changes unless the user does something; 0 while things move
  void frame(double elapsed);
  void follow_kernels();
  void simulate(double elapsed, bool one_step);
  void capture(const Requests& requests);
  void finish(double wall_s);

  void carry_out(const Requests& requests);
  void take_over(std::unique_ptr<Session> opened);
  void session_began();
  void set_title();
  void resume(const std::filesystem::path& file);
  void rescale(double factor);
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
  int frames_to_settle_;  // to draw although nothing moves
  bool settled_ = false;  // nothing has happened since settle()
  bool shown_ = false;    // this session, in a frame: steps come after the first picture
};

}  // namespace fascia
