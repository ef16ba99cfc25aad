// Two settings of one scene side by side: A is the open session, B another session of the same bodies with other
// settings. Both make the same steps under the same grab and are drawn with the same camera. Exists only during a
// comparison.
#pragma once
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "app/overlay/grab_marks.h"
#include "app/session/framing.h"
#include "app/session/session.h"
#include "app/state/undo_history.h"
#include "gl/timing/timer.h"

struct ImDrawList;

namespace fascia {

/// Cost and accuracy of a side in one line; the time of a step, or that the side sleeps, only if it is `measured`.
std::string side_result(const Session& session, const std::optional<Diagnostics>& diagnostics, double step_ms,
                        bool measured);

class SplitView {
 public:
  /// B is `scene` in the current state of A; `model` belongs to it. Throws Error if it has other vertices than A, or if
  /// one of them uses the reference solver.
  SplitView(Graphics& graphics, const Session& a, Scene scene, Model model);

  Session& b() { return *b_; }
  const Session& b() const { return *b_; }
  UndoHistory history;  // of the side that is not shown in the panels

  /// Gives the other side the springs of `grab`, which is one of the two sessions, or those of A while a replay plays.
  void lead(Session& a, Session& grab);
  /// One step of both with these springs. A replay's inputs to A apply to B, too: grabs, gravity, time step, resets;
  /// settings and materials if both have the same.
  void step(Session& a, Session& grab);
  void reset(Session& a);               // both to the start of A
  void restart_from(const Session& a);  // sets B to the current state of A
  /// Copies common properties from the side that changed: display, gravity, time step.
  void share(Session& a);
  /// Exchanges A and B.
  void swap(std::unique_ptr<Session>& a);
  bool asleep() const { return b_->simulation.asleep(); }

  void request_diagnostics() { b_->simulation.gpu()->request_diagnostics(); }     // of B's current state
  bool take_diagnostics(bool wait);                                               // whether there were new ones
  const std::optional<Diagnostics>& diagnostics() const { return diagnostics_; }  // the last ones taken
  bool busy() const { return b_->measuring_error() || b_->simulation.gpu()->diagnosing(); }  // results are pending

  struct Area {
    int x = 0, width = 0;  // [pixels] of the picture
  };
  /// The areas of the sides in a picture of this width. The color bar is at the right of B, beside an area as large as
  /// that of A.
  static std::array<Area, 2> areas(int width, const Margins& margins);
  /// The same area in a list whose unit is `scale` pixels, in a picture of this height.
  static MarkArea area_of(ImDrawList& list, const Area& area, int height, float scale);
  using SideGrabs = std::array<std::vector<GrabMark>, 2>;
  /// The grabs of A and B; `of_user` is null if there are none.
  SideGrabs grabs(const Session& a, const std::optional<Diagnostics>& of_a, const GrabSet* of_user) const;
  /// `drawn`, if given, is called with each side's own picture, which has a depth buffer.
  void draw(Session& a, Framebuffer& framebuffer, const Margins& margins, const SideGrabs& grabs,
            const std::function<void(std::size_t, const Framebuffer&)>& drawn = {});
  struct Labels {
    const std::optional<Diagnostics>& of_a;
    bool measured;   // with times
    bool editing_b;  // the panels show B
    const SideGrabs& grabs;
    std::vector<Box> covered;  // by windows and the like
  };
  /// Draws over a picture of `width` x `height` pixels with the same margins: a description of each side, its cost and
  /// accuracy, and its grabs. The list's unit is `scale` pixels.
  void draw_labels(ImDrawList& list, const Session& a, int width, int height, const Margins& margins, float scale,
                   const Labels& labels) const;

 private:
  struct Side {
    gl::Timer timer;
    double step_ms = 0;
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
  Framebuffer& picture_of(int width, int height, int samples);

  std::unique_ptr<Session> b_;
  std::array<Side, 2> sides_;
  std::array<std::unique_ptr<Framebuffer>, 2> pictures_;  // for a side: in the window, and in a video of another size
  Shared shared_;
  std::optional<Diagnostics> diagnostics_;  // of B
  int lost_ = 0;                            // number of divergences of B
};

}  // namespace fascia
