#include <fstream>

#include "tests/api/api_scenes.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;
using Catch::Contains;

TEST_CASE("The vertices of a box are numbered as the header states") {
  const Mesh mesh = make_box(2, 3, 4, {0.2, 0.3, 0.4});
  REQUIRE(mesh.vertex_count() == 3 * 4 * 5);
  CHECK(mesh.tet_count() == 6 * 2 * 3 * 4);
  const std::size_t v = (3 * (3 + 1) + 2) * (2 + 1) + 1;  // i, j, k = 1, 2, 3
  CHECK(mesh.positions[3 * v] == Approx(0.1));
  CHECK(mesh.positions[3 * v + 1] == Approx(0.2));
  CHECK(mesh.positions[3 * v + 2] == Approx(0.3));
  CHECK_THAT(error_of([] { make_box(0, 1, 1, {1, 1, 1}); }), Contains("cells below 1"));
  CHECK_THAT(error_of([] { make_box(1, 1, 1, {1, -1, 1}); }), Contains("not positive"));
}

TEST_CASE("A mesh file is read with its regions, and an unreadable one is an Error that names it") {
  const TemporaryFolder folder;
  std::ofstream(folder / "two.mesh")
      << "MeshVersionFormatted 1\nDimension 3\nVertices 5\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n1 1 1 0\n"
         "Tetrahedra 2\n1 2 3 4 7\n2 3 4 5 9\nEnd\n";
  const Mesh mesh = read_mesh(folder / "two.mesh");
  CHECK(mesh.vertex_count() == 5);
  CHECK(mesh.tets == std::vector<std::uint32_t>{0, 1, 2, 3, 1, 2, 3, 4});
  CHECK(mesh.regions == std::vector<int>{7, 9});
  CHECK_THAT(error_of([&] { read_mesh(folder / "none.msh"); }), Contains("none.msh"));
}
