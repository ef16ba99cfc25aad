// A scene that is stepped and drawn without a window: what render and check share, so that both make the same picture.
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
  /// Opens what the options name, and says so unless they are quiet. Throws Error. The options must outlive it.
  explicit Headless(const RenderOptions& options);

  /// Makes the steps that the options ask for, or finds the static equilibrium; ends early when interrupted.
  /// `after_step` runs at the start, too. Throws Error when a vertex is lost.
  void run(const std::function<void()>& after_step = {});

  /// The scene as it is now, with panels and color bar where they are wanted, whatever was drawn before. Throws Error
  /// when a vertex is lost.
  Framebuffer& draw();
  /// The same after `step` steps, with these positions and colors (null: those of now), seen by the camera and with the
  /// grabs of then; panels, the range of colors and which vertices are held are of now. A replay goes on to the same
  /// bits afterwards.
  Framebuffer& draw(double step, const gl::Buffer* positions);
  /// The display is that of a replay after `step` steps.
  void show_as_of(double step);
  /// Keeps where the grabs are now, for pictures of this moment that are drawn later.
  void remember_grabs();

  Session& session() { return session_; }
  long step() const { return step_; }
  long steps() const { return steps_; }  // that run() makes
  Provenance provenance() const;         // of this moment
  Outcome outcome();                     // the same, drawn, with the state that it shows

 private:
  Headless(const RenderOptions& options, Opened opened);
  void look(double step);
  std::optional<Diagnostics> diagnose();
  std::optional<Diagnostics> diagnose_grabs();  // nothing where nobody holds anything
  Margins margins(bool bar);                    // of the picture
  Framebuffer& draw_split(const std::optional<Diagnostics>& diagnostics);

  const RenderOptions& options_;
  Graphics graphics_;
  Session session_;
  Supersampler picture_;
  RenderCamera camera_;
  ReplayView view_;
  DisplaySettings opened_;                              // until a replay has another one
  std::deque<std::vector<GrabMark>> remembered_grabs_;  // after the last steps, that of now at the end
  Overlay overlay_;
  std::optional<SplitView> split_;  // with --split
  long step_ = 0, steps_ = 0;
};

}  // namespace fascia
