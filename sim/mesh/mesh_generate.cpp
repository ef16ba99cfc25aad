#include "sim/mesh/mesh_generate.h"

#include <cstddef>

namespace fascia {

TetMesh make_box(int nx, int ny, int nz, const Eigen::Vector3d& size) {
  const auto vertex = [=](int i, int j, int k) {
    const std::size_t row = static_cast<std::size_t>(nx) + 1, layer = row * (static_cast<std::size_t>(ny) + 1);
    return static_cast<std::uint32_t>(static_cast<std::size_t>(k) * layer + static_cast<std::size_t>(j) * row +
                                      static_cast<std::size_t>(i));
  };
  TetMesh mesh;
  for (int k = 0; k <= nz; ++k) {
    for (int j = 0; j <= ny; ++j) {
      for (int i = 0; i <= nx; ++i) {
        mesh.positions.push_back(size.cwiseProduct(Eigen::Vector3d(double(i) / nx, double(j) / ny, double(k) / nz)));
      }
    }
  }
  // One tet per order of the three axes on a path from the cell's low corner to its high one; odd orders have the
  // opposite winding. Every cell cuts its faces along the same diagonal, so neighbors conform.
  constexpr int kOrders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
  for (int k = 0; k < nz; ++k) {
    for (int j = 0; j < ny; ++j) {
      for (int i = 0; i < nx; ++i) {
        for (int order = 0; order < 6; ++order) {
          int corner[3] = {i, j, k};
          Tet tet;
          tet[0] = vertex(i, j, k);
          for (int step = 0; step < 3; ++step) {
            ++corner[kOrders[order][step]];
            tet[static_cast<std::size_t>(step) + 1] = vertex(corner[0], corner[1], corner[2]);
          }
          if (order >= 3) std::swap(tet[1], tet[2]);
          mesh.tets.push_back(tet);
        }
      }
    }
  }
  mesh.regions.assign(mesh.tets.size(), 0);
  return mesh;
}

void deform(TetMesh& mesh, const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& map) {
  for (Eigen::Vector3d& position : mesh.positions) position = map(position);
}

}  // namespace fascia
