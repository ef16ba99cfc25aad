// Two settings of one scene side by side: A is the session that is open, B another of the same bodies with other settings. Both make the
// same steps under the same hand and are drawn with the same camera. Exists only while two are compared.
#pragma once
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "app/dial_history.h"
#include "app/session.h"
#include "render/gl/timer.h"

namespace fascia {

class SplitView {
 public:
  /// B is `scene` in the state that A is in; `model` goes with it. Throws Error if it has other vertices than A, or where one of them is
  /// solved by the reference solver.
  SplitView(Graphics& graphics, const Session& a, Scene scene, Model model);

  Session& b() { return *b_; }
  const Session& b() const { return *b_; }
  DialHistory history;  // of the side that the panels do not show

  /// One step of both, under the springs of `hand`, which is one of them. What a replay does to A happens to B, too: hands, gravity, time
  /// step, resets; settings and materials where both have the same.
  void step(Session& a, Session& hand);
  void reset(Session& a);               // both to where A starts
  void restart_from(const Session& a);  // B into the state that A is in
  /// What both must have in common goes over from the side where it changed: display, gravity, time step.
  void share(Session& a);
  /// A becomes B and B becomes A.
  void swap(std::unique_ptr<Session>& a);
  bool asleep() const { return b_->simulation.asleep(); }

  /// B's diagnostics of the latest state, where there are any; asked for every time. `wait`: of the state of now.
  const std::optional<Diagnostics>& diagnose(bool wait);

  struct Area {
    int x = 0, width = 0;  // [pixels] of the picture
  };
  /// Where the sides are in a picture of this width whose first `left` pixels belong to the panels.
  static std::array<Area, 2> areas(int width, int left);
  void draw(Session& a, Framebuffer& framebuffer, int left, std::span<const GrabMark> hands);
  /// Over the picture: what each side is, and what it costs and reaches. Between ImGui::NewFrame and ImGui::Render.
  void draw_labels(const Session& a, const std::optional<Diagnostics>& diagnostics, int left, bool measured, bool editing_b) const;

 private:
  struct Side {
    gl::Timer timer;
    double step_ms = 0;
    std::unique_ptr<Framebuffer> picture;
  };
  struct Shared {
    DisplaySettings display;
    Eigen::Vector3d gravity;
    double time_step;
    bool operator==(const Shared&) const = default;
  };
  static Shared shared_of(const Session& session);
  static void apply(const Shared& shared, Session& session);
  static void make_step(Session& session, Side& side);
  void follow(Session& a, const std::function<void()>& change_a);

  std::unique_ptr<Session> b_;
  std::array<Side, 2> sides_;
  Shared shared_;
  std::optional<Diagnostics> diagnostics_;  // of B
  int lost_ = 0;                            // times that B came apart
};

/// "Two-level, Subspace, 10 iterations", and with `with_material` "E 20 kPa, nu 0.4".
std::string side_text(const Session& session, bool with_material);

}  // namespace fascia
