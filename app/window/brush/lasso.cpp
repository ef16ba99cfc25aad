#include "app/window/brush/lasso.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "app/state/deformed_positions.h"
#include "app/window/brush/depth_map.h"
#include "sim/mesh/tet_faces.h"

namespace fascia {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kStep = 2;             // between the points of a curve [pixels]
constexpr double kSameSurface = 0.002;  // a place so little behind the visible one is on the same surface [scene radii]

/// The part of the picture that a curve encloses.
class Enclosed {
 public:
  Enclosed(const std::vector<Vector2d>& curve, BrushedPicture picture) : curve_(curve) {
    for (const Vector2d& place : curve) {
      low_ = low_.cwiseMin(place);
      high_ = high_.cwiseMax(place);
    }
    low_ = low_.cwiseMax(Vector2d::Zero());
    high_ = high_.cwiseMin(Vector2d(picture.width, picture.height));
  }

  bool empty() const { return curve_.size() < 3 || !(low_.array() < high_.array()).all(); }
  /// With the neighbors of its border.
  DepthMap map() const {
    const Vector2d one(1, 1);
    return {(low_ - one).array().floor().cast<int>(), (high_ + one).array().floor().cast<int>()};
  }
  /// Inside of an odd number of loops.
  bool has(double x, double y) const {
    if (!(x >= low_.x() && x <= high_.x() && y >= low_.y() && y <= high_.y())) return false;
    bool inside = false;
    for (std::size_t i = 0, j = curve_.size() - 1; i < curve_.size(); j = i++) {
      const Vector2d &a = curve_[i], &b = curve_[j];
      if ((a.y() > y) != (b.y() > y) && x < a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) inside = !inside;
    }
    return inside;
  }

 private:
  const std::vector<Vector2d>& curve_;
  Vector2d low_ = Vector2d::Constant(std::numeric_limits<double>::max()), high_ = -low_;
};

/// The tissue as the picture shows it.
class Seen {
 public:
  Seen(Session& session, BrushedPicture picture)
      : session_(session),
        picture_(picture),
        transform_(
            (session.camera.projection(static_cast<double>(picture.width) / picture.height, session.look.radius) *
             session.camera.view())
                .cast<double>()),
        cut_(shown_cut(session.look)),
        positions_(deformed_positions(session)) {}

  const std::vector<Vector3d>& positions() const { return positions_; }
  double beyond_cut(const Vector3d& place) const {
    return cut_ ? cut_->normal.cast<double>().dot(place) - cut_->offset : -1;
  }
  DepthMap::Corner corner(const Vector3d& place) const {
    const Eigen::Vector4d clip = transform_ * place.homogeneous();
    return {(0.5 + 0.5 * clip.x() / clip.w()) * picture_.width, (0.5 - 0.5 * clip.y() / clip.w()) * picture_.height,
            clip.w(), beyond_cut(place)};
  }
  /// A triangle that reaches behind the eye is left out: a lasso takes nothing through the eye.
  DepthMap depth_of(const std::vector<Triangle>& boundary, const Enclosed& enclosed) const {
    DepthMap map = enclosed.map();
    for (const Triangle& t : boundary) {
      const DepthMap::Corner a = corner(positions_[t[0]]), b = corner(positions_[t[1]]), c = corner(positions_[t[2]]);
      if (std::min({a.distance, b.distance, c.distance}) > 0) map.add(a, b, c);
    }
    if (cut_ && beyond_cut(session_.camera.eye) > 0)
      map.close_cut([&](double x, double y) {
        const Ray ray = session_.camera.ray(x, y, picture_.width, picture_.height);
        const double slope = cut_->normal.cast<double>().dot(ray.direction);
        return -beyond_cut(ray.origin) / slope * ray.direction.dot(session_.camera.forward());
      });
    return map;
  }

 private:
  const Session& session_;
  BrushedPicture picture_;
  Eigen::Matrix4d transform_;
  std::optional<SectionCut> cut_;
  std::vector<Vector3d> positions_;
};

}  // namespace

void Lasso::move(const Vector2d& at) {
  if (drawing() && (at - curve_.back()).norm() >= kStep) curve_.push_back(at);
}

std::vector<Vector2d> Lasso::finish() { return std::exchange(curve_, {}); }

std::vector<std::uint32_t> vertices_within(const std::vector<Vector2d>& curve, BrushedPicture picture,
                                           Session& session) {
  const Enclosed enclosed(curve, picture);
  if (enclosed.empty()) return {};
  const Seen seen(session, picture);
  const std::vector<Triangle> boundary = boundary_triangles(session.simulation.model.tets);
  const DepthMap map = seen.depth_of(boundary, enclosed);
  std::vector<std::uint32_t> vertices;
  for (const Triangle& t : boundary)
    for (const std::uint32_t v : t) {
      const DepthMap::Corner place = seen.corner(seen.positions()[v]);
      if (place.distance > 0 && place.beyond <= 0 && enclosed.has(place.x, place.y) &&
          place.distance <= map.farthest_around(place.x, place.y) + kSameSurface * session.look.radius)
        vertices.push_back(v);
    }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

std::vector<std::uint32_t> tets_within(const std::vector<Vector2d>& curve, BrushedPicture picture, Session& session,
                                       std::optional<double> depth) {
  const Enclosed enclosed(curve, picture);
  if (enclosed.empty()) return {};
  const Seen seen(session, picture);
  const std::vector<Tet>& model_tets = session.simulation.model.tets;
  const std::vector<Vector3d> centroids = centroids_of(model_tets, seen.positions());
  std::optional<DepthMap> map;
  if (depth) map = seen.depth_of(boundary_triangles(model_tets), enclosed);
  std::vector<std::uint32_t> tets;
  for (std::uint32_t t = 0; t < centroids.size(); ++t) {
    const DepthMap::Corner center = seen.corner(centroids[t]);
    if (!(center.distance > 0 && center.beyond <= 0 && enclosed.has(center.x, center.y))) continue;
    if (depth) {
      double nearest = center.distance;
      for (const std::uint32_t v : model_tets[t])
        nearest = std::min(nearest, seen.corner(seen.positions()[v]).distance);
      if (nearest > map->nearest(center.x, center.y) + *depth + kSameSurface * session.look.radius) continue;
    }
    tets.push_back(t);
  }
  return tets;
}

}  // namespace fascia
