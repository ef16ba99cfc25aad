// Boxes of the speed benchmarks.
#include "app/bench/box.h"

#include <catch2/catch.hpp>

#include "sim/mesh/mesh_check.h"

using namespace fascia;

TEST_CASE("a box has about the requested number of tets, in cells that are nearly cubes") {
  for (const std::size_t tets : {500u, 5000u, 50000u, 500000u, 1000000u}) {
    const Eigen::Vector3i cells = cells_of(tets);
    const double made = 6.0 * cells.prod(), shape = cells.x() / (4.0 * cells.y());
    CAPTURE(tets, made, shape);
    CHECK(cells.y() == cells.z());
    CHECK(made == Approx(static_cast<double>(tets)).epsilon(0.1));
    CHECK(shape == Approx(1).epsilon(0.5));
  }
  CHECK(cells_of(1) == Eigen::Vector3i(2, 2, 2));
}

TEST_CASE("a box is 1 m by 0.25 m by 0.25 m and held at x = 0") {
  const Model model = box_model({4, 2, 1});
  CHECK(model.tets.size() == 48);
  CHECK(model.tet_material == std::vector<std::uint32_t>(48, 0));
  CHECK(model.rest_positions.size() == 30);
  CHECK(model.initial_velocity.size() == 30);
  CHECK(model.fixed.size() == 6);
  for (const std::uint32_t v : model.fixed) CHECK(model.rest_positions[v].x() == 0);
  const MeshReport report = examine(model.file_mesh, repair(model.file_mesh));
  CHECK(report.volume == Approx(0.0625));
  CHECK(report.box_max == Eigen::Vector3d(1, 0.25, 0.25));
  REQUIRE(model.materials.size() == 1);
  CHECK(model.materials[0].young_modulus == 1e6);
  CHECK(model.materials[0].density == 1000);
}
