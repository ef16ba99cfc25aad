#include "sim/tool/solid_mesh.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/text.h"
#include "sim/surface/surface_repair.h"
#include "sim/surface/triangle_tree.h"

namespace fascia {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kCells = 64, kMostCells = 128;  // along the longest side
constexpr double kCellsAcross = 4;               // of a thin part
constexpr int kMargin = 3;                       // cells around the surface

void require_closed(const SurfaceRepair& repaired, const std::string& where) {
  if (const SurfaceReport& report = repaired.report; !repaired.closed())
    throw Error(where, "is open: " + plural(report.open_edges.count, "edge") + " of one triangle only",
                "expected a closed surface");
  require_fillable(repaired, where);
}

// The sign stays from one node to the next where both are so far from the surface that it cannot pass between them.
void measure(const TriangleTree& tree, SolidMesh& solid) {
  const auto [nx, ny, nz] = solid.count;
  solid.distances.reserve(static_cast<std::size_t>(nx) * ny * nz);
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j) {
      double before = 0;
      for (int i = 0; i < nx; ++i) {
        const Vector3d node = solid.origin + solid.spacing * Vector3d(i, j, k);
        const double distance = tree.nearest(node).distance;
        const bool stays = i > 0 && std::abs(before) + distance > 1.01 * solid.spacing;
        const bool inside = stays ? before < 0 : tree.is_inside(node);
        before = inside ? -distance : distance;
        solid.distances.push_back(static_cast<float>(before));
      }
    }
}

// Values, and first and second derivatives, of the quadratic B-splines of three nodes at t in [-1/2, 1/2] from the
// middle one, in cells.
struct Weights {
  Vector3d value, slope, bend;
  explicit Weights(double t)
      : value(0.5 * (0.5 - t) * (0.5 - t), 0.75 - t * t, 0.5 * (0.5 + t) * (0.5 + t)),
        slope(t - 0.5, -2 * t, t + 0.5),
        bend(1, -2, 1) {}
};

ShapeDistance within(const SolidMesh& solid, const Vector3d& place) {
  const Vector3d middle = place.unaryExpr([](double c) { return std::floor(c + 0.5); });
  const Weights x(place.x() - middle.x()), y(place.y() - middle.y()), z(place.z() - middle.z());
  const Eigen::Vector3i first = middle.cast<int>() - Eigen::Vector3i::Ones();
  double value = 0;
  Vector3d slope(0, 0, 0);
  Matrix3d bend = Matrix3d::Zero();
  for (int c = 0; c < 3; ++c)
    for (int b = 0; b < 3; ++b)
      for (int a = 0; a < 3; ++a) {
        const auto node = static_cast<std::size_t>(first.x() + a) +
                          static_cast<std::size_t>(solid.count[0]) *
                              (static_cast<std::size_t>(first.y() + b) +
                               static_cast<std::size_t>(solid.count[1]) * static_cast<std::size_t>(first.z() + c));
        const double d = solid.distances[node];
        value += d * x.value[a] * y.value[b] * z.value[c];
        slope += d * Vector3d(x.slope[a] * y.value[b] * z.value[c], x.value[a] * y.slope[b] * z.value[c],
                              x.value[a] * y.value[b] * z.slope[c]);
        const double xy = d * x.slope[a] * y.slope[b] * z.value[c], xz = d * x.slope[a] * y.value[b] * z.slope[c],
                     yz = d * x.value[a] * y.slope[b] * z.slope[c];
        bend += (Matrix3d() << d * x.bend[a] * y.value[b] * z.value[c], xy, xz, xy,
                 d * x.value[a] * y.bend[b] * z.value[c], yz, xz, yz, d * x.value[a] * y.value[b] * z.bend[c])
                    .finished();
      }
  return {value, slope / solid.spacing, bend / (solid.spacing * solid.spacing)};
}

struct Place {  // in cells
  Vector3d point, clamped, last;
};
Place place_in(const SolidMesh& solid, const Vector3d& point) {
  const Vector3d place = (point - solid.origin) / solid.spacing;
  const Vector3d last(solid.count[0] - 1.5, solid.count[1] - 1.5, solid.count[2] - 1.5);
  return {place, place.cwiseMax(0.5).cwiseMin(last), last};
}

}  // namespace

SolidMesh solid_of(const SurfaceMesh& surface, double scale, const std::string& where) {
  SurfaceRepair repaired = repair(surface);
  require_closed(repaired, where);
  SolidMesh solid;
  solid.positions = std::move(repaired.positions);
  for (Vector3d& x : solid.positions) x *= scale;
  solid.triangles = std::move(repaired.triangles);
  solid.thickness = 2 * scale * std::abs(repaired.report.volume) / repaired.report.area;
  solid.tree = std::make_shared<const TriangleTree>(solid.positions, solid.triangles);
  solid.box = solid.tree->box();
  const double longest = solid.box.sizes().maxCoeff();
  solid.spacing = std::clamp(solid.thickness / kCellsAcross, longest / kMostCells, longest / kCells);
  solid.origin = solid.box.min() - kMargin * Vector3d::Constant(solid.spacing);
  for (int axis = 0; axis < 3; ++axis)
    solid.count[static_cast<std::size_t>(axis)] =
        static_cast<int>(std::ceil(solid.box.sizes()[axis] / solid.spacing)) + 2 * kMargin + 1;
  measure(*solid.tree, solid);
  return solid;
}

ShapeDistance distance_to(const SolidMesh& solid, const Vector3d& point) {
  const auto [place, clamped, last] = place_in(solid, point);
  ShapeDistance at = within(solid, clamped.cwiseMin(last - Vector3d::Constant(1e-9)));
  const Vector3d away = solid.spacing * (place - clamped);
  if (away.isZero(0)) return at;
  // The surface lies behind the side of the grid on which the clamped point is. Both distances are taken for square to
  // each other; where the surface is straight behind, they add up, and the result is up to 1 - 1/sqrt(2) too short.
  const double distance = std::hypot(away.norm(), at.distance);
  const Vector3d along = away.unaryExpr([](double a) { return a == 0 ? 1.0 : 0.0; }).cwiseProduct(at.normal);
  return {distance, (away + at.distance * along) / distance, Matrix3d::Zero()};
}

double gap_to(const SolidMesh& solid, const Vector3d& point) {
  const Place at = place_in(solid, point);
  return at.point == at.clamped ? distance_to(solid, point).distance : solid.tree->nearest(point).distance;
}

}  // namespace fascia
