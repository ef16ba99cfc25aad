// Meshes from formulas: for tests, benchmarks and the shipped assets.
#pragma once
#include <functional>

#include "sim/mesh/tet_mesh.h"

namespace fascia {

/// Box [0,size] of nx*ny*nz cells, each cut into 6 tets around its main diagonal (conforming). size [m].
TetMesh make_box(int nx, int ny, int nz, const Eigen::Vector3d& size);

/// Moves every vertex by `map` from rest position to rest position.
void deform(TetMesh& mesh, const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& map);

}  // namespace fascia
