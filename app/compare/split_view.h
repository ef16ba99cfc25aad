// Two settings of one scene side by side: A is the session that is open, B another of the same bodies with other
// settings. Both make the same steps under the same grab and are drawn with the same camera. Exists only while two are
// compared.
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
#include "gl/timer.h"

struct ImDrawList;

namespace fascia {

/// What a side costs and reaches, in one line; the time of a step, or that it sleeps, only where it is `measured`.
std::string side_result(const Session& session, const std::optional<Diagnostics>& diagnostics, double step_ms,
                        bool measured);

class SplitView {
 public:
  /// B is `scene` in the state that A is in; `model` goes with it. Throws Error if it has other vertices than A, or
  /// where one of them is solved by the reference solver.
  SplitView(Graphics& graphics, const Session& a, Scene scene, Model model);

  Session& b() { return *b_; }
  const Session& b() const { return *b_; }
  UndoHistory history;  // of the side that the panels do not show

  /// The other side gets the springs of `grab`, which is one of them, or of A while a replay leads it.
  void lead(Session& a, Session& grab);
  /// One step of both, led so. What a replay does to A happens to B, too: grabs, gravity, time step, resets; settings
  /// and materials where both have the same.
  void step(Session& a, Session& grab);
  void reset(Session& a);               // both to where A starts
  void restart_from(const Session& a);  // B into the state that A is in
  /// What both must have in common goes over from the side where it changed: display, gravity, time step.
  void share(Session& a);
  /// A becomes B and B becomes A.
  void swap(std::unique_ptr<Session>& a);
  bool asleep() const { return b_->simulation.asleep(); }

  void request_diagnostics() { b_->simulation.gpu()->request_diagnostics(); }     // of B's state of now
  bool take_diagnostics(bool wait);                                               // whether there were any that are new
  const std::optional<Diagnostics>& diagnostics() const { return diagnostics_; }  // the last ones taken
  bool busy() const { return b_->true_error.busy() || b_->simulation.gpu()->diagnosing(); }  // results are under way

  struct Area {
    int x = 0, width = 0;  // [pixels] of the picture
  };
  /// Where the sides are in a picture of this width. B's has the color bar at its right, beside as much room as A has.
  static std::array<Area, 2> areas(int width, const Margins& margins);
  /// Such an area in a list whose unit is `scale` pixels, of a picture of this height.
  static MarkArea area_of(ImDrawList& list, const Area& area, int height, float scale);
  using SideGrabs = std::array<std::vector<GrabMark>, 2>;
  /// What pulls at A and at B; `of_user` null where there is none.
  SideGrabs grabs(const Session& a, const std::optional<Diagnostics>& of_a, const GrabSet* of_user) const;
  /// `drawn`, if any, is called with each side's own picture, which has a depth.
  void draw(Session& a, Framebuffer& framebuffer, const Margins& margins, const SideGrabs& grabs,
            const std::function<void(std::size_t, const Framebuffer&)>& drawn = {});
  struct Labels {
    const std::optional<Diagnostics>& of_a;
    bool measured;   // with times
    bool editing_b;  // which side the panels show
    const SideGrabs& grabs;
    std::vector<Box> covered;  // by windows and the like
  };
  /// Over a picture of `width` x `height` pixels with the same margins: what each side is, what it costs and reaches,
  /// and its grabs. The list's unit is `scale` pixels.
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
  std::array<std::unique_ptr<Framebuffer>, 2> pictures_;  // of a side: in the window, and in a video of another size
  Shared shared_;
  std::optional<Diagnostics> diagnostics_;  // of B
  int lost_ = 0;                            // times that B came apart
};

}  // namespace fascia
