#include "sim/contact/tissue/penetration.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/contact/tissue/tissue_surface.h"
#include "sim/surface/surface_repair.h"
#include "sim/surface/triangle_tree.h"

namespace fascia {
namespace {

using Eigen::Vector3d;
using Corners = std::array<Vector3d, 4>;

constexpr double kRounding = 1e-6;  // of barycentric coordinates

double volume6(const Vector3d& a, const Vector3d& b, const Vector3d& c) { return a.cross(b).dot(c); }

constexpr double kTouching = 1e-3;  // of a body's size: what lies on the other's surface but for rounding

std::vector<Vector3d> middles_of_tets(const Model& model, const BodyPart& body) {
  std::vector<Vector3d> middles;
  const auto& x = model.rest_positions;
  for (std::uint32_t t = body.tet_begin; t < body.tet_begin + body.tet_count; ++t) {
    const Tet& tet = model.tets[t];
    middles.emplace_back((x[tet[0]] + x[tet[1]] + x[tet[2]] + x[tet[3]]) / 4);
  }
  return middles;
}

std::vector<Vector3d> vertices_of_tets(const Model& model, const BodyPart& body) {
  std::vector<char> used(body.vertex_count, 0);
  for (std::uint32_t t = body.tet_begin; t < body.tet_begin + body.tet_count; ++t)
    for (const std::uint32_t v : model.element(t)) used[v - body.vertex_begin] = 1;
  std::vector<Vector3d> vertices;
  for (std::uint32_t v = 0; v < body.vertex_count; ++v)
    if (used[v]) vertices.push_back(model.rest_positions[body.vertex_begin + v]);
  return vertices;
}

// The cubic volume of the three edges from vertex 0 as they move.
class Volume {
 public:
  Volume(const Corners& from, const Corners& to) {
    const Vector3d a = from[1] - from[0], b = from[2] - from[0], c = from[3] - from[0];
    const Vector3d da = to[1] - to[0] - a, db = to[2] - to[0] - b, dc = to[3] - to[0] - c;
    k_ = {volume6(a, b, c), volume6(da, b, c) + volume6(a, db, c) + volume6(a, b, dc),
          volume6(a, db, dc) + volume6(da, b, dc) + volume6(da, db, c), volume6(da, db, dc)};
  }
  double at(double t) const { return k_[0] + t * (k_[1] + t * (k_[2] + t * k_[3])); }

  // The roots between 0 and 1, ascending.
  std::vector<double> roots() const {
    std::vector<double> ends{0};
    for (const double t : turns())
      if (t > 0 && t < 1) ends.push_back(t);
    ends.push_back(1);
    std::vector<double> roots;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
      double low = ends[i], high = ends[i + 1];
      const bool rises = at(low) < 0;
      if (rises == (at(high) < 0)) continue;
      for (int halves = 0; halves < 52; ++halves) {
        const double middle = 0.5 * (low + high);
        ((at(middle) < 0) == rises ? low : high) = middle;
      }
      roots.push_back(0.5 * (low + high));
    }
    return roots;
  }

 private:
  // Where the slope is 0, ascending.
  std::vector<double> turns() const {
    const double a = 3 * k_[3], b = 2 * k_[2], c = k_[1], root = b * b - 4 * a * c;
    if (root < 0) return {};
    const double q = -0.5 * (b + std::copysign(std::sqrt(root), b));
    std::vector<double> turns;
    if (a != 0) turns.push_back(q / a);
    if (q != 0) turns.push_back(c / q);
    std::sort(turns.begin(), turns.end());
    return turns;
  }
  std::array<double, 4> k_;
};

// `weights_at`(corners, weights, normal): whether the sides meet there, and the normal of any length.
template <class F>
std::optional<Passage> first_passage(const Corners& from, const Corners& to, F&& weights_at) {
  const Volume volume(from, to);
  double before = 0;
  for (const double share : volume.roots()) {
    Passage passage;
    passage.share = share;
    Corners now;
    for (std::size_t k = 0; k < 4; ++k) now[k] = from[k] + share * (to[k] - from[k]);
    const bool meets = weights_at(now, passage.weights, passage.normal);
    const double length = passage.normal.norm();
    if (meets && length > 0) {
      // On which side the first one was before.
      const double middle = 0.5 * (before + share);
      double gap = 0;
      for (std::size_t k = 0; k < 4; ++k)
        gap += passage.weights[k] * passage.normal.dot(from[k] + middle * (to[k] - from[k]));
      passage.normal /= gap < 0 ? -length : length;
      return passage;
    }
    before = share;
  }
  return std::nullopt;
}

}  // namespace

bool goes_through(const Vector3d& p, const Vector3d& q, const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const double above = signed_volume6(a, b, c, p), below = signed_volume6(a, b, c, q);
  if ((above > 0) == (below > 0) || above == 0 || below == 0) return false;
  const bool ab = signed_volume6(p, q, a, b) > 0, bc = signed_volume6(p, q, b, c) > 0,
             ca = signed_volume6(p, q, c, a) > 0;
  return ab == bc && bc == ca;
}

std::size_t penetrating_triangles(const Model& model, const std::vector<Vector3d>& displacement) {
  std::vector<Vector3d> positions = model.rest_positions;
  for (std::size_t v = 0; v < positions.size(); ++v) positions[v] += displacement[v];
  return self_intersections(TriangleTree(std::move(positions), tissue_boundary(model))).pairs.count;
}

std::vector<Overlap> overlaps_at_rest(const Model& model) {
  const auto count = static_cast<std::uint32_t>(model.bodies.size());
  std::vector<std::vector<Triangle>> boundaries(count);
  const std::vector<std::uint32_t> bodies = bodies_of_vertices(model);
  for (const Triangle& triangle : tissue_boundary(model)) boundaries[bodies[triangle[0]]].push_back(triangle);
  std::vector<TriangleTree> surfaces;
  for (std::vector<Triangle>& boundary : boundaries) surfaces.emplace_back(model.rest_positions, std::move(boundary));

  std::vector<Overlap> overlaps;
  for (std::uint32_t a = 0; a < count; ++a)
    for (std::uint32_t b = 0; b < count; ++b) {
      if (a == b || !surfaces[a].box().intersects(surfaces[b].box())) continue;
      Overlap overlap{a, b};
      const double touching = kTouching * surfaces[a].box().sizes().maxCoeff();
      const auto count_inside = [&](const std::vector<Vector3d>& points) {
        std::size_t inside = 0;
        for (const Vector3d& x : points) {
          if (!surfaces[b].box().contains(x) || !surfaces[b].is_inside(x)) continue;
          const double depth = surfaces[b].nearest(x).distance;
          if (depth <= touching) continue;
          ++inside;
          overlap.deepest = std::max(overlap.deepest, depth);
        }
        return inside;
      };
      overlap.vertices = count_inside(vertices_of_tets(model, model.bodies[a]));
      overlap.tets = count_inside(middles_of_tets(model, model.bodies[a]));
      if (overlap.vertices + overlap.tets > 0) overlaps.push_back(overlap);
    }
  return overlaps;
}

std::optional<Passage> vertex_through_triangle(const Corners& from, const Corners& to) {
  return first_passage(from, to, [](const Corners& x, std::array<double, 4>& weights, Vector3d& normal) {
    const Vector3d b = x[2] - x[1], c = x[3] - x[1], local = x[0] - x[1];
    normal = b.cross(c);
    const double twice_area2 = normal.squaredNorm();
    if (twice_area2 == 0) return false;
    const double beta = local.cross(c).dot(normal) / twice_area2, gamma = b.cross(local).dot(normal) / twice_area2;
    weights = {1, beta + gamma - 1, -beta, -gamma};
    return std::min({1 - beta - gamma, beta, gamma}) >= -kRounding;
  });
}

std::optional<Passage> edge_through_edge(const Corners& from, const Corners& to) {
  return first_passage(from, to, [](const Corners& x, std::array<double, 4>& weights, Vector3d& normal) {
    const Vector3d a = x[1] - x[0], b = x[3] - x[2], between = x[2] - x[0];
    const double aa = a.squaredNorm(), bb = b.squaredNorm(), ab = a.dot(b), det = aa * bb - ab * ab;
    if (det <= 1e-12 * aa * bb) return false;
    const double p = between.dot(a), q = between.dot(b);
    const double s = (bb * p - ab * q) / det, t = (ab * p - aa * q) / det;
    normal = a.cross(b);
    weights = {1 - s, s, t - 1, -t};
    return std::min({s, 1 - s, t, 1 - t}) >= -kRounding;
  });
}

// The nearest points of the lines, led back into the segments (Lumelsky 1985).
double distance_between(const std::array<Vector3d, 2>& a, const std::array<Vector3d, 2>& b) {
  const Vector3d along_a = a[1] - a[0], along_b = b[1] - b[0], between = a[0] - b[0];
  const double aa = along_a.squaredNorm(), bb = along_b.squaredNorm(), ab = along_a.dot(along_b);
  const double of_a = along_a.dot(between), of_b = along_b.dot(between), det = aa * bb - ab * ab;
  const auto share = [](double numerator, double denominator) {
    return denominator > 0 ? std::clamp(numerator / denominator, 0.0, 1.0) : 0.0;
  };
  double s = det > 1e-12 * aa * bb ? share(ab * of_b - of_a * bb, det) : 0;
  const double t = share(ab * s + of_b, bb);
  s = share(ab * t - of_a, aa);
  return (between + s * along_a - t * along_b).norm();
}

double distance_to_triangle(const std::array<Vector3d, 2>& segment, const std::array<Vector3d, 3>& t) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Vector3d& end : segment) {
    const Vector3d w = nearest_weights(end, t[0], t[1], t[2]);
    nearest = std::min(nearest, (end - w[0] * t[0] - w[1] * t[1] - w[2] * t[2]).norm());
  }
  for (std::size_t k = 0; k < 3; ++k) nearest = std::min(nearest, distance_between(segment, {t[k], t[(k + 1) % 3]}));
  return nearest;
}

}  // namespace fascia
