#include "sim/gpu/contact/piece_rows.h"

#include "sim/tool/solid_mesh.h"

namespace fascia {

using Eigen::Vector3d;
using shared::vec4;

vec4 row_of(const Vector3d& v, double w) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z()), static_cast<float>(w)};
}

PieceRows piece_rows_of(const ToolShape& shape, std::size_t first_node) {
  struct Rows {
    std::size_t first_node;

    PieceRows operator()(const SphereShape& s) const { return {0, row_of(s.center, s.radius), row_of({0, 0, 0}, 0)}; }
    PieceRows operator()(const CapsuleShape& s) const {
      const Vector3d along = s.to - s.from;
      return {0, row_of(s.from, s.radius), row_of(along, 1 / along.squaredNorm())};
    }
    PieceRows operator()(const BoxShape& s) const {
      return {1, row_of(s.center, s.round), row_of(s.half_size.array() - s.round)};
    }
    PieceRows operator()(const PlaneShape& s) const { return {2, row_of(s.point), row_of(s.normal.normalized())}; }
    PieceRows operator()(const CylinderShape& s) const {
      const Vector3d along = s.to - s.from;
      return {3, row_of(0.5 * (s.from + s.to), s.radius), row_of(along.normalized(), 0.5 * along.norm())};
    }
    PieceRows operator()(const MeshShape& s) const {
      const auto& count = s.solid->count;
      return {4, row_of(s.solid->origin, s.solid->spacing),
              row_of({1.0 * count[0], 1.0 * count[1], 1.0 * count[2]}, static_cast<double>(first_node))};
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
