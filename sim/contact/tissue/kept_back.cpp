#include "sim/contact/tissue/kept_back.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "sim/elements/quadratic_tet.h"
#include "sim/tool/shape_distance.h"

namespace fascia {

using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

// A principal stretch. Nearly incompressible tissue gives to the sides: its volume says nothing.
constexpr double kCrushed = 0.15;
constexpr double kNothing = 1e-3;  // of a way
// Of a way that is left of it along crushed tissue: a hand that presses on would else drill itself in step by step.
constexpr double kAlong = 0.5;
constexpr int kSweeps = 32;  // over the places that a way is led along

// A place that the tool comes no closer to.
struct Stop {
  Vector3d place, away;  // `away`: from the tool, a unit vector
  std::size_t piece;     // that is nearest
  double distance;       // from it [m]
};

Stop stop_at(const Tool& tool, const ToolPlace& place, const Vector3d& point) {
  Stop stop{point, {0, 0, 0}, 0, std::numeric_limits<double>::infinity()};
  for (std::size_t piece = 0; piece < tool.piece_count(); ++piece) {
    const RigidPose pose = tool.pose_of_piece(piece, place);
    const ShapeDistance found = distance_to(tool.shape, pose.to_local(point));
    if (found.distance < stop.distance) stop = {point, pose.axes * found.normal.normalized(), piece, found.distance};
  }
  return stop;
}

Vector3d centroid_of(const Tet& tet, std::span<const Vector3d> positions) {
  return 0.25 * (positions[tet[0]] + positions[tet[1]] + positions[tet[2]] + positions[tet[3]]);
}

double least_stretch(const Matrix3d& gradient) {
  const Matrix3d squared = gradient.transpose() * gradient;
  const double least =
      Eigen::SelfAdjointEigenSolver<Matrix3d>().computeDirect(squared, Eigen::EigenvaluesOnly).eigenvalues()[0];
  return std::copysign(std::sqrt(std::max(0.0, least)), gradient.determinant());
}

Matrix3d edges(const Corners& x) {
  Matrix3d edges;
  edges << x[1] - x[0], x[2] - x[0], x[3] - x[0];
  return edges;
}

}  // namespace

double least_stretch(const Model& model, std::size_t tet, std::span<const Vector3d> positions) {
  const ElementVertices vertices = model.element(tet);
  Corners rest, now;
  for (std::size_t a = 0; a < 4; ++a) {
    rest[a] = model.rest_positions[vertices[a]];
    now[a] = positions[vertices[a]];
  }
  if (!model.is_quadratic(tet)) return least_stretch(edges(now) * edges(rest).inverse());
  QuadraticTet::Nodes moved;
  for (std::size_t n = 0; n < vertices.size(); ++n)
    moved[n] = positions[vertices[n]] - model.rest_positions[vertices[n]];
  const LinearTet corners(rest);
  double least = std::numeric_limits<double>::infinity();
  for (const Matrix3d& gradient : QuadraticTet(corners).at_points(moved))
    least = std::min(least, least_stretch(Matrix3d::Identity() + gradient));
  return least;
}

namespace {

std::vector<Stop> stops_of(const Model& model, std::span<const Vector3d> positions, const Tool& tool,
                           const ToolPlace& from, double near) {
  std::vector<Vector3d> centers;  // of balls around the pieces
  for (std::size_t piece = 0; piece < tool.piece_count(); ++piece)
    centers.push_back(tool.pose_of_piece(piece, from).to_scene(middle_of(tool.shape)));
  const double reach = bounding_radius(tool.shape) + near;
  std::vector<Stop> stops;
  for (std::size_t t = 0; t < model.tets.size(); ++t) {
    const Vector3d middle = centroid_of(model.tets[t], positions);
    if (std::none_of(centers.begin(), centers.end(),
                     [&](const Vector3d& center) { return (middle - center).norm() < reach; }) ||
        least_stretch(model, t, positions) >= kCrushed)
      continue;
    if (const Stop stop = stop_at(tool, from, middle); stop.distance < near) stops.push_back(stop);
  }
  return stops;
}

}  // namespace

ToolPlace kept_back(const Model& model, std::span<const Vector3d> positions, const Tool& tool, const ToolPlace& from,
                    const ToolPlace& to, double near) {
  const std::vector<Stop> stops = stops_of(model, positions, tool, from, near);
  const auto closes = [&](const Stop& stop) {
    const RigidPose begin = tool.pose_of_piece(stop.piece, from), end = tool.pose_of_piece(stop.piece, to);
    return (end.to_scene(begin.to_local(stop.place)) - stop.place).dot(stop.away) > 0;
  };
  if (std::none_of(stops.begin(), stops.end(), closes)) return to;
  const Vector3d whole = to.pose.origin - from.pose.origin;
  Vector3d way = whole;
  for (int sweep = 0; sweep < kSweeps; ++sweep)
    for (const Stop& stop : stops) way -= std::max(0.0, way.dot(stop.away)) * stop.away;
  const bool still_closes = std::any_of(stops.begin(), stops.end(),
                                        [&](const Stop& stop) { return way.dot(stop.away) > kNothing * way.norm(); });
  if (still_closes || way.norm() < kAlong * whole.norm()) return from;
  ToolPlace along = from;
  along.pose.origin += way;
  return along;
}

}  // namespace fascia
