// Triangles of rigid shapes, for pictures.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "sim/mesh/tet_mesh.h"
#include "sim/scene/tools/scene_tools.h"

namespace fascia {

struct ShapeMesh {
  std::vector<Eigen::Vector3f> positions, normals;  // [vertex] in the axes of the shape [m]; a vertex per normal
  std::vector<Triangle> triangles;                  // wound outward
};

/// `reach`: the radius of the disc that stands for a plane [m].
ShapeMesh shape_mesh(const ToolShape& shape, double reach);

}  // namespace fascia
