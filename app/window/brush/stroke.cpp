#include "app/window/brush/stroke.h"

#include <Eigen/LU>
#include <limits>
#include <utility>

#include "app/state/deformed_positions.h"
#include "sim/visual/picking.h"

namespace fascia {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Matrix3d edges_of(const Tet& tet, const std::vector<Vector3d>& positions) {
  Matrix3d edges;
  for (int k = 0; k < 3; ++k) edges.col(k) = positions[tet[static_cast<std::size_t>(k) + 1]] - positions[tet[0]];
  return edges;
}

}  // namespace

std::vector<Vector3d> centroids_of(const std::vector<Tet>& tets, const std::vector<Vector3d>& positions) {
  std::vector<Vector3d> centroids;
  centroids.reserve(tets.size());
  for (const Tet& t : tets)
    centroids.push_back(0.25 * (positions[t[0]] + positions[t[1]] + positions[t[2]] + positions[t[3]]));
  return centroids;
}

bool Stroke::begin(const Eigen::Vector2d& at, BrushedPicture picture, Session& session, Marks marks, double radius) {
  under_way_ = true;
  marks_ = marks;
  marked_.clear();
  positions_ = deformed_positions(session);
  const Model& model = session.simulation.model;
  if (marks == Marks::tets) {
    centroids_ = centroids_of(model.tets, positions_);
    rests_ = centroids_of(model.tets, model.rest_positions);
  }
  move(at, picture, session, radius);
  under_way_ = !marked_.empty();
  return under_way_;
}

void Stroke::move(const Eigen::Vector2d& at, BrushedPicture picture, const Session& session, double radius) {
  if (!under_way_) return;
  const Ray ray = session.camera.ray(at.x(), at.y(), picture.width, picture.height);
  const auto hit = pick(ray, session.surface().triangles, positions_, shown_cut(session.look));
  if (!hit) return;
  if (marks_ == Marks::vertices)
    mark_vertices(hit->point, session.simulation.model, radius);
  else
    mark_tets(hit->point, session.simulation.model, radius);
}

// Marks the vertices of tets around the place under the mouse, on the surface and below it; the nearest one where the
// mesh is coarser than the brush.
void Stroke::mark_vertices(const Vector3d& point, const Model& model, double radius) {
  std::uint32_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (const Tet& tet : model.tets)
    for (const std::uint32_t v : tet) {
      const double distance = (positions_[v] - point).norm();
      if (distance <= radius) marked_.insert(v);
      if (distance < least) {
        least = distance;
        nearest = v;
      }
    }
  marked_.insert(nearest);
}

// The place at rest follows from the deformation of the nearest tet, which is marked, too: also on a section plane, and
// where the mesh is coarser than the brush.
void Stroke::mark_tets(const Vector3d& point, const Model& model, double radius) {
  std::uint32_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t t = 0; t < centroids_.size(); ++t)
    if (const double distance = (centroids_[t] - point).squaredNorm(); distance < least) {
      least = distance;
      nearest = t;
    }
  const Tet& tet = model.tets[nearest];
  const Matrix3d now = edges_of(tet, positions_);
  Vector3d offset = point - centroids_[nearest];
  // A tet without volume has no unique place at rest: its displacement alone is taken back
  if (std::abs(now.determinant()) > 1e-3 * std::abs(edges_of(tet, model.rest_positions).determinant()))
    offset = edges_of(tet, model.rest_positions) * now.inverse() * offset;
  const Vector3d rest = rests_[nearest] + offset;
  for (std::uint32_t t = 0; t < rests_.size(); ++t)
    if ((rests_[t] - rest).squaredNorm() <= radius * radius) marked_.insert(t);
  marked_.insert(nearest);
}

std::vector<std::uint32_t> Stroke::finish() {
  under_way_ = false;
  positions_.clear();
  centroids_.clear();
  rests_.clear();
  const std::set<std::uint32_t> marked = std::exchange(marked_, {});
  return {marked.begin(), marked.end()};
}

std::vector<Vector3d> Stroke::places() const {
  std::vector<Vector3d> places;
  if (under_way_)
    for (const std::uint32_t i : marked_) places.push_back(marks_ == Marks::vertices ? positions_[i] : centroids_[i]);
  return places;
}

}  // namespace fascia
