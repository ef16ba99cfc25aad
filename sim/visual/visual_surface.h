// The drawn surface of a model: the boundary of its tets or, for bodies with a surface of their own, that surface
// embedded in them.
#pragma once
#include <vector>

#include "sim/model/model.h"

namespace fascia {

struct VisualSurface {
  std::vector<Triangle> triangles;
  std::vector<Eigen::Vector3d> rest_positions;  // mesh vertices, then embedded ones, as in GpuSolver::positions() [m]
  std::vector<std::uint32_t> colors{};          // as SurfaceMesh::colors, of all triangles; empty if no surface has any
};
VisualSurface drawn_surface(const Model& model);
/// The vertices of the drawn surface that stand for `vertices` of the mesh in a picture: in a body with a surface of
/// its own the embedded vertices that lie nearest to them, since its tets are not drawn.
std::vector<std::uint32_t> drawn_marks(const Model& model, const std::vector<std::uint32_t>& vertices);
/// Whether there are bodies with surfaces of their own and all of these enclose a volume.
bool closed_around_tets(const Model& model);

}  // namespace fascia
