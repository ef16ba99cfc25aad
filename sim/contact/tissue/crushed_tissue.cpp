#include "sim/contact/tissue/crushed_tissue.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <vector>

#include "sim/elements/quadratic_tet.h"
#include "sim/tool/shape_distance.h"

namespace fascia {

using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

constexpr double kCrushed = 0.1;  // det F

double signed_distance(const Tool& tool, const ToolPlace& place, const Vector3d& point) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t piece = 0; piece < tool.piece_count(); ++piece)
    nearest = std::min(nearest, distance_to(tool.shape, tool.pose_of_piece(piece, place).to_local(point)).distance);
  return nearest;
}

Vector3d centroid_of(const Tet& tet, std::span<const Vector3d> positions) {
  return 0.25 * (positions[tet[0]] + positions[tet[1]] + positions[tet[2]] + positions[tet[3]]);
}

double six_volumes(const Corners& x) { return (x[1] - x[0]).cross(x[2] - x[0]).dot(x[3] - x[0]); }

}  // namespace

double least_volume_ratio(const Model& model, std::size_t tet, std::span<const Vector3d> positions) {
  const ElementVertices vertices = model.element(tet);
  Corners rest, now;
  for (std::size_t a = 0; a < 4; ++a) {
    rest[a] = model.rest_positions[vertices[a]];
    now[a] = positions[vertices[a]];
  }
  if (!model.is_quadratic(tet)) return six_volumes(now) / six_volumes(rest);
  QuadraticTet::Nodes moved;
  for (std::size_t n = 0; n < vertices.size(); ++n)
    moved[n] = positions[vertices[n]] - model.rest_positions[vertices[n]];
  const LinearTet corners(rest);
  double least = std::numeric_limits<double>::infinity();
  for (const Matrix3d& gradient : QuadraticTet(corners).at_points(moved))
    least = std::min(least, (Matrix3d::Identity() + gradient).determinant());
  return least;
}

bool presses_crushed_tissue(const Model& model, std::span<const Vector3d> positions, const Tool& tool,
                            const ToolPlace& from, const ToolPlace& to, double near) {
  std::vector<Vector3d> centers;  // of balls around the pieces
  for (std::size_t piece = 0; piece < tool.piece_count(); ++piece)
    centers.push_back(tool.pose_of_piece(piece, from).to_scene(middle_of(tool.shape)));
  const double reach = bounding_radius(tool.shape) + near;
  for (std::size_t t = 0; t < model.tets.size(); ++t) {
    const Vector3d middle = centroid_of(model.tets[t], positions);
    if (std::none_of(centers.begin(), centers.end(),
                     [&](const Vector3d& center) { return (middle - center).norm() < reach; }) ||
        least_volume_ratio(model, t, positions) >= kCrushed)
      continue;
    const double now = signed_distance(tool, from, middle);
    if (now < near && signed_distance(tool, to, middle) < now) return true;
  }
  return false;
}

}  // namespace fascia
