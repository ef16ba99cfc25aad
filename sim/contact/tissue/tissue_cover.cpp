#include "sim/contact/tissue/tissue_cover.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/contact/tissue/tissue_surface.h"
#include "sim/tool/followed_place.h"
#include "sim/tool/shape_distance.h"

namespace fascia {

using Eigen::Vector3d;

namespace {
constexpr int kMostParts = 8;  // along an edge
}

TissueCover::TissueCover(const Model& model, double radius)
    : radius_(radius), half_thickness_(0.5 * model.contact.thickness), faces_(tissue_boundary(model)) {
  follow(model.rest_positions);
}

void TissueCover::follow(std::span<const Vector3d> positions) {
  balls_.clear();
  box_.setEmpty();
  for (const Triangle& face : faces_) {
    const Vector3d center = (positions[face[0]] + positions[face[1]] + positions[face[2]]) / 3;
    double radius2 = 0;
    for (const std::uint32_t v : face) {
      radius2 = std::max(radius2, (positions[v] - center).squaredNorm());
      box_.extend(positions[v]);
    }
    // In n^2 triangles alike, those that point the other way included.
    const int n = std::clamp(static_cast<int>(std::ceil(std::sqrt(radius2) / radius_)), 1, kMostParts);
    const Vector3d first = (positions[face[1]] - positions[face[0]]) / n,
                   second = (positions[face[2]] - positions[face[0]]) / n;
    for (int i = 0; i < n; ++i)
      for (int j = 0; i + j < n; ++j)
        for (const double third : {1.0 / 3, 2.0 / 3})
          if (third < 0.5 || i + j + 1 < n)
            balls_.push_back({positions[face[0]] + (i + third) * first + (j + third) * second, std::sqrt(radius2) / n});
  }
}

double TissueCover::clearance(const Tool& tool, const ToolPlace& place) const {
  const double bound = bounding_radius(tool.shape), afar = 2 * finest_radius(tool.shape);
  const Vector3d middle = middle_of(tool.shape);
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t piece = 0; piece < tool.piece_count(); ++piece) {
    const RigidPose pose = tool.pose_of_piece(piece, place);
    const Vector3d center = pose.to_scene(middle);
    if (const double beyond = box_.exteriorDistance(center) - bound; beyond > afar) {
      nearest = std::min(nearest, beyond);
      continue;
    }
    for (const Ball& ball : balls_) {
      if ((ball.center - center).norm() - bound - ball.radius >= nearest) continue;
      nearest = std::min(nearest, distance_to(tool.shape, pose.to_local(ball.center)).distance - ball.radius);
    }
  }
  return nearest;
}

bool TissueCover::is_met_by(const Tool& tool, const ToolPlace& from, const ToolPlace& to) const {
  if (from == to) return false;
  const double reach = way_between(tool, from, to, size()) + kContactMargin * size() + half_thickness_;
  return clearance(tool, from) <= reach;
}

}  // namespace fascia
