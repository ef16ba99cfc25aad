// Marks over the tissue: position and force of the grabs of the user, of the scene and of a replay, and other marked
// places.
#pragma once
#include <optional>
#include <vector>

#include "app/session/session.h"
#include "app/ui/label_places.h"
#include "sim/grab/grab_set.h"

struct ImDrawList;
struct ImVec4;

namespace fascia {

inline constexpr float kLabelGap = 3;      // between labels [points]
inline constexpr double kMarkRadius = 11;  // of the handle of a grab [1/720 of the picture's height]

struct GrabMark {
  GrabArrow arrow;        // from the tissue to the target: in the direction of the force, as long as the springs
  Eigen::Vector3d force;  // [N]
  bool stays = false;     // a grab of the user that does not follow the mouse and can be taken up by its handle
};

/// `forces` as last observed; `grabs` of the user, null if there are none.
std::vector<GrabMark> grab_marks(const Simulation& simulation, const std::vector<GrabForce>& forces,
                                 const GrabSet* grabs);
std::vector<GrabArrow> arrows(const std::vector<GrabMark>& marks);

/// Pixel of a place in a picture of the session; none behind the camera.
std::optional<Eigen::Vector2d> pixel_of(const Session& session, const Eigen::Vector3d& place, double width,
                                        double height);

/// A draw list and the area of a session's picture in it, in the list's units.
struct MarkArea {
  ImDrawList& list;
  float x, width, height;
  Box box() const { return {x, 0, x + width, height}; }
  static MarkArea whole();  // ImGui's background, between ImGui::NewFrame and ImGui::Render
};

/// Draws handles and forces in newtons, the latter where `places` has room for them.
void draw_grab_marks(const MarkArea& area, const Session& session, const std::vector<GrabMark>& marks,
                     LabelPlaces& places);

/// Draws a circle with the patch's radius [m] on the tissue at this place, perpendicular to `normal`.
void draw_patch_ring(const MarkArea& area, const Session& session, const Eigen::Vector3d& place,
                     const Eigen::Vector3d& normal, double radius);

/// Draws a dot at each place [m], or at a sample of very many: what is under the brush.
void draw_brush_marks(const MarkArea& area, const Session& session, const std::vector<Eigen::Vector3d>& places,
                      const ImVec4& color);
/// Draws a curve, in pixels of the area, whose ends are joined.
void draw_lasso(const MarkArea& area, const std::vector<Eigen::Vector2d>& curve);

/// Draws a dot at `place` [m], the position of the plotted vertex.
void draw_probe(const MarkArea& area, const Session& session, const Eigen::Vector3d& place);

}  // namespace fascia
