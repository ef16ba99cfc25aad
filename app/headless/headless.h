// Steps and draws a scene without a window. The commands render and check share this code, so that both produce the
// same picture.
#pragma once
#include <deque>
#include <functional>

#include "app/cli/options.h"
#include "app/compare/split_view.h"
#include "app/golden/golden.h"
#include "app/headless/render_camera.h"
#include "app/overlay/grab_marks.h"
#include "app/overlay/overlay.h"
#include "app/session/framing.h"
#include "app/session/open_input.h"
#include "app/session/session.h"
#include "render/supersampler.h"
#include "sim/output/run_provenance.h"

namespace fascia {

class Headless {
 public:
  /// Opens the input of the options and reports it, unless they are quiet. Throws Error. The options must outlive this
  /// object. `nudge`: moves the vertices at rest by up to so many sizes of the scene, always the same way.
  explicit Headless(const RenderOptions& options, double nudge = 0);

  /// Makes the steps that the options request, or finds the static equilibrium; ends early when interrupted.
  /// `after_step` also runs at the start. Throws Error if the state diverges.
  void run(const std::function<void()>& after_step = {});

  /// Draws the current scene, with panels and legend if requested, independent of earlier pictures. Throws Error if
  /// the state has diverged.
  Framebuffer& draw();
  /// The same after `step` steps, at this simulated time [s], with these positions and colors (null: the current ones),
  /// and with the camera and the grabs of that time; panels, the range of colors and the set of grabbed vertices are
  /// the current ones. A replay continues to the same bits afterwards.
  Framebuffer& draw(double step, double time, const gl::Buffer* positions);
  /// Sets the display to that of a replay after `step` steps.
  void show_as_of(double step);
  /// Stores the current grabs, for pictures of this time that are drawn later.
  void remember_grabs();

  Session& session() { return session_; }
  long step() const { return step_; }
  long steps() const { return steps_; }  // number of steps that run() makes
  /// Simulated time that the camera's own motion takes: one turn, or all keys [s]. Length of a video of tissue at rest.
  double camera_seconds() const { return camera_seconds_; }
  Provenance provenance() const;  // of the current picture
  Outcome outcome();              // draws the current picture, and includes its state

 private:
  Headless(const RenderOptions& options, Opened opened);
  void look(double step, double time);
  void start_camera(double seconds);
  std::optional<Diagnostics> diagnose();
  std::optional<Diagnostics> diagnose_grabs();  // none without grabs
  void scale_overlay();
  Margins margins(bool legend);  // of the picture
  Framebuffer& draw_split(const std::optional<Diagnostics>& diagnostics);

  const RenderOptions& options_;
  Graphics graphics_;
  Session session_;
  Supersampler picture_;
  RenderCamera camera_;
  ReplayView view_;
  DisplaySettings opened_;                              // until a replay changes it
  std::deque<std::vector<GrabMark>> remembered_grabs_;  // after the last steps, the current ones at the end
  Overlay overlay_;
  std::optional<SplitView> split_;  // with --split
  double camera_seconds_ = 0;       // that the camera's own motion takes
  long step_ = 0, steps_ = 0;
};

}  // namespace fascia
