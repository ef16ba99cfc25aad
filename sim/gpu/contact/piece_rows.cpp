#include "sim/gpu/contact/piece_rows.h"

#include "sim/tool/solid_mesh.h"

namespace fascia {

using Eigen::Vector3d;
using shared::vec4;

Vector3d rounding_of(const Vector3d& v) {
  Vector3d lost;
  for (Eigen::Index k = 0; k < 3; ++k) {
    const volatile float rounded = static_cast<float>(v[k]);  // GCC 12 takes (double)(float) of vectors for nothing
    lost[k] = v[k] - rounded;
  }
  return lost;
}

vec4 row_of(const Vector3d& v, double w) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z()), static_cast<float>(w)};
}

PieceRows piece_rows_of(const ToolShape& shape, std::size_t first_node) {
  struct Rows {
    std::size_t first_node;

    static double lost(double size) { return rounding_of({size, 0, 0}).x(); }
    PieceRows operator()(const SphereShape& s) const {
      return {0, row_of(s.center, s.radius), row_of({0, 0, 0}, 0), rounding_of(s.center), {0, 0, 0}, lost(s.radius)};
    }
    PieceRows operator()(const CapsuleShape& s) const {
      const Vector3d along = s.to - s.from;
      return {0,
              row_of(s.from, s.radius),
              row_of(along, 1 / along.squaredNorm()),
              rounding_of(s.from),
              {0, 0, 0},
              lost(s.radius)};
    }
    PieceRows operator()(const BoxShape& s) const {
      const Vector3d half = s.half_size.array() - s.round;
      return {1, row_of(s.center, s.round), row_of(half), rounding_of(s.center), rounding_of(half), lost(s.round)};
    }
    PieceRows operator()(const PlaneShape& s) const {
      return {2, row_of(s.point), row_of(s.normal.normalized()), rounding_of(s.point), {0, 0, 0}, 0};
    }
    PieceRows operator()(const CylinderShape& s) const {
      const Vector3d along = s.to - s.from;
      const Vector3d middle = 0.5 * (s.from + s.to);
      return {3,
              row_of(middle, s.radius - s.round),
              row_of(along.normalized(), 0.5 * along.norm() - s.round),
              rounding_of(middle),
              {0, 0, 0},
              lost(s.round),
              s.round};
    }
    PieceRows operator()(const MeshShape& s) const {
      const auto& count = s.solid->count;
      return {4,
              row_of(s.solid->origin, s.solid->spacing),
              row_of({1.0 * count[0], 1.0 * count[1], 1.0 * count[2]}, static_cast<double>(first_node)),
              {0, 0, 0},
              {0, 0, 0},
              0};
    }
  };
  return std::visit(Rows{first_node}, shape);
}

gl::Defines defines_of_shapes(const std::set<int>& kinds) {
  gl::Defines defines;
  for (const auto& [kind, name] :
       {std::pair{0, "CAPSULES"}, {1, "BOXES"}, {2, "PLANES"}, {3, "CYLINDERS"}, {4, "MESHES"}})
    defines.emplace_back(name, kinds.contains(kind) ? "1" : "0");
  return defines;
}

}  // namespace fascia
