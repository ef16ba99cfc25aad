#include "app/window/parts/fix_brush.h"

#include <limits>
#include <utility>

#include "app/state/deformed_positions.h"
#include "sim/visual/picking.h"

namespace fascia {

bool FixBrush::begin(const Eigen::Vector2d& at, Picture picture, Session& session, double radius) {
  painting_ = true;
  marked_.clear();
  positions_ = deformed_positions(session);
  move(at, picture, session, radius);
  painting_ = !marked_.empty();
  return painting_;
}

// Marks the vertices of tets around the place under the mouse, on the surface and below it; the nearest one where the
// mesh is coarser than the brush.
void FixBrush::move(const Eigen::Vector2d& at, Picture picture, const Session& session, double radius) {
  if (!painting_) return;
  const Ray ray = session.camera.ray(at.x(), at.y(), picture.width, picture.height);
  const auto hit = pick(ray, session.surface().triangles, positions_, shown_cut(session.look));
  if (!hit) return;
  std::uint32_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (const Tet& tet : session.simulation.model.tets)
    for (const std::uint32_t v : tet) {
      const double distance = (positions_[v] - hit->point).norm();
      if (distance <= radius) marked_.insert(v);
      if (distance < least) {
        least = distance;
        nearest = v;
      }
    }
  marked_.insert(nearest);
}

std::vector<std::uint32_t> FixBrush::finish() {
  painting_ = false;
  positions_.clear();
  const std::set<std::uint32_t> marked = std::exchange(marked_, {});
  return {marked.begin(), marked.end()};
}

std::vector<Eigen::Vector3d> FixBrush::places() const {
  std::vector<Eigen::Vector3d> places;
  if (painting_)
    for (const std::uint32_t v : marked_) places.push_back(positions_[v]);
  return places;
}

}  // namespace fascia
