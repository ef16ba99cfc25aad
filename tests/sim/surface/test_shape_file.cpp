// A file as tets or as a surface, whichever it holds.
#include "sim/surface/shape_file.h"

#include <catch2/catch.hpp>

#include "base/error.h"
#include "sim/surface/surface_fill.h"
#include "tests/support/support.h"
#include "tests/support/surfaces.h"

using namespace fascia;

namespace {

ShapeFile read(const std::string& name, const std::string& content) { return read_shape_content(name, content, {}); }

}  // namespace

TEST_CASE("a file is a surface if it holds faces and no tets, whatever its ending") {
  const std::string vertices = "MeshVersionFormatted 2\nDimension 3\nVertices 4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n";
  const std::string skin = "Triangles 4\n1 3 2 5\n1 2 4 5\n2 3 4 5\n3 1 4 5\n";
  const ShapeFile surface = read("a.mesh", vertices + skin + "End\n");
  REQUIRE(surface.surface);
  CHECK(surface.surface->format == "Medit ASCII");
  CHECK(surface.surface->triangles == std::vector<Triangle>{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
  CHECK(surface.surface->colors.empty());
  const ShapeFile tets = read("a.mesh", vertices + skin + "Tetrahedra 1\n1 2 3 4 0\nEnd\n");
  CHECK_FALSE(tets.surface);
  CHECK(tets.tets.mesh.tets.size() == 1);
  CHECK(tets.tets.faces.ends.empty());
  CHECK(read("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").surface->triangles.size() == 1);
  CHECK_THROWS_WITH(read("a.mesh", vertices + "End\n"), Catch::Contains("holds no tets (4 vertices"));
}

TEST_CASE("polygons are divided, colors of vertices kept, and groups are named in a note") {
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nproperty float "
      "red\nproperty float green\nproperty float blue\nelement face 1\nproperty list uchar int "
      "vertex_index\nend_header\n"
      "0 0 0 1 0 0\n1 0 0 0 1 0\n1 1 0 0 0 1\n0 1 0 1 1 1\n4 0 1 2 3\n";
  const SurfaceMesh quad = *read("a.ply", ply).surface;
  REQUIRE(quad.triangles.size() == 2);
  CHECK(quad.vertex_colors);
  const std::uint32_t colors[] = {0xff0000ff, 0xff00ff00, 0xffff0000, 0xffffffff};
  REQUIRE(quad.colors.size() == 6);
  for (std::size_t t = 0; t < 2; ++t)
    for (std::size_t k = 0; k < 3; ++k) CHECK(quad.colors[3 * t + k] == colors[quad.triangles[t][k]]);

  const std::string msh =
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n2 9 \"skin\"\n$EndPhysicalNames\n$Nodes\n3\n1 0 0 0\n2 "
      "1 0 "
      "0\n3 0 1 0\n$EndNodes\n$Elements\n1\n1 2 2 9 1 1 2 3\n$EndElements\n";
  CHECK(read("a.msh", msh).surface->notes ==
        std::vector<std::string>{"groups of a surface are not those of its tets: left out skin"});
}

TEST_CASE("every file of a box is filled as that box is") {
  const auto volume_of = [](const TetMesh& mesh) {
    double volume = 0;
    const auto& x = mesh.positions;
    for (const Tet& t : mesh.tets) volume += signed_volume6(x[t[0]], x[t[1]], x[t[2]], x[t[3]]) / 6;
    return volume;
  };
  const MeshFile box = fill_surface(test::make_box_surface({0.1, 0.2, 0.3}), "box", 8).file;
  CHECK(box.filled.value() == Approx(volume_of(box.mesh) / (0.1 * 0.2 * 0.3)).epsilon(1e-6));
  for (const auto& entry : std::filesystem::directory_iterator(test::test_dir() / "data/meshes/surfaces")) {
    INFO(entry.path().filename().string());
    const MeshFile file = read_mesh_or_fill(entry.path(), 8);
    CHECK(file.mesh.tets.size() == box.mesh.tets.size());
    CHECK(volume_of(file.mesh) == Approx(volume_of(box.mesh)).epsilon(1e-5));  // files in float32
  }
}
