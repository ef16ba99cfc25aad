// What is drawn of a model: the boundary of its tets or, for bodies with a surface of their own, that surface embedded in them.
#pragma once
#include <vector>

#include "sim/model.h"

namespace fascia {

struct DrawnSurface {
  std::vector<Triangle> triangles;
  std::vector<Eigen::Vector3d> rest_positions;  // mesh vertices, then embedded ones, as in GpuSolver::positions() [m]
  std::vector<std::uint32_t> colors{};          // as SurfaceMesh::colors, of all triangles; empty if no surface has any
};
/// `only_tets`: the boundaries of the tets of all bodies.
DrawnSurface drawn_surface(const Model& model, bool only_tets = false);

}  // namespace fascia
