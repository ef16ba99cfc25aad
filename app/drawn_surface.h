// What is drawn of a model: the boundary of its tets or, for bodies with a "surface" file, that surface embedded in them.
#pragma once
#include <vector>

#include "sim/model.h"
#include "sim/scene.h"

namespace fascia {

/// Vertices of all embedded surfaces of the scene, placed; they follow the mesh vertices in GpuSolver::positions(). Reads
/// the .obj files; throws Error.
std::vector<Eigen::Vector3d> embedded_points(const Scene& scene);

struct DrawnSurface {
  std::vector<Triangle> triangles;
  std::vector<Eigen::Vector3d> rest_positions;  // mesh vertices, then embedded ones [m]
};
DrawnSurface drawn_surface(const Scene& scene, const Model& model);

}  // namespace fascia
