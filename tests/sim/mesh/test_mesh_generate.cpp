// Generated boxes: counts, size, winding, conformity.
#include "sim/mesh/mesh_generate.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "sim/mesh/mesh_check.h"

using namespace fascia;

TEST_CASE("a box has the requested counts, corners and volume") {
  const Eigen::Vector3d size(2, 0.5, 3);
  const TetMesh mesh = make_box(3, 2, 5, size);
  CHECK(mesh.positions.size() == 4u * 3 * 6);
  CHECK(mesh.tets.size() == 6u * 3 * 2 * 5);
  CHECK(mesh.regions == std::vector<int>(mesh.tets.size(), 0));
  CHECK(mesh.positions.front() == Eigen::Vector3d(0, 0, 0));
  CHECK(mesh.positions.back() == size);

  double volume = 0;
  for (const Tet& tet : mesh.tets) {
    const double volume6 =
        signed_volume6(mesh.positions[tet[0]], mesh.positions[tet[1]], mesh.positions[tet[2]], mesh.positions[tet[3]]);
    // All six tets of a cell have a sixth of its volume; the coordinates are rounded to 1e-16.
    CHECK(volume6 == Approx(size.prod() / 30).epsilon(1e-12));
    volume += volume6 / 6;
  }
  CHECK(volume == Approx(size.prod()).epsilon(1e-12));
}

TEST_CASE("a box is valid: conforming cells, one component, a manifold boundary") {
  const TetMesh mesh = make_box(3, 2, 4, {0.3, 0.2, 0.4});
  const MeshReport report = examine(mesh, repair(mesh));
  CHECK(report.usable_tets == mesh.tets.size());
  CHECK(report.flipped == 0);
  CHECK(report.unused_vertices == 0);
  CHECK(report.components == 1);
  CHECK(report.boundary_manifold);
  // A face that is cut differently by its neighbors would stay on the boundary.
  CHECK(report.boundary_triangles == 4u * (3 * 2 + 2 * 4 + 4 * 3));
  CHECK(report.smallest_dihedral_deg == Approx(45).epsilon(1e-9));  // cells are cubes here
}

TEST_CASE("deform maps every vertex and does not change the tets") {
  TetMesh mesh = make_box(1, 1, 1, {1, 1, 1});
  const std::vector<Tet> tets = mesh.tets;
  deform(mesh, [](const Eigen::Vector3d& p) { return Eigen::Vector3d(2 * p.x(), p.y() + 1, p.z() * p.x()); });
  CHECK(mesh.tets == tets);
  CHECK(mesh.positions.front() == Eigen::Vector3d(0, 1, 0));
  CHECK(mesh.positions.back() == Eigen::Vector3d(2, 2, 1));
}
