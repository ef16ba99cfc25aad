// Files written by other programs (tests/data/meshes; their names begin with the program), against the known properties
// of the bodies in them.
#include <catch2/catch.hpp>
#include <map>

#include "base/file.h"
#include "sim/mesh/io/formats.h"
#include "tests/support/support.h"

using namespace fascia;
using fascia::test::test_dir;

namespace {

std::map<int, double> volume_of_regions(const TetMesh& mesh) {
  std::map<int, double> volumes;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    const Tet& tet = mesh.tets[t];
    const auto& x = mesh.positions;
    volumes[mesh.regions[t]] += std::abs(signed_volume6(x[tet[0]], x[tet[1]], x[tet[2]], x[tet[3]])) / 6;
  }
  return volumes;
}

struct Expected {
  std::string file, format;
  std::size_t vertices, triangles;
  int left, right;  // regions of the boxes at x < 1 and x > 1
};

}  // namespace

TEST_CASE("two boxes as Gmsh and VTK write them", "[mesh_io]") {
  const auto expected = GENERATE(values<Expected>({
      {"gmsh_1.msh", "Gmsh 1.0 ASCII", 23, 4, 7, 3},
      {"gmsh_2.2_binary.msh", "Gmsh 2.2 binary", 23, 4, 7, 3},
      {"gmsh_4.1_binary_partitioned.msh", "Gmsh 4.1 binary", 23, 12, 7, 3},  // and the triangles between partitions
      {"gmsh_4.1_second_order.msh", "Gmsh 4.1 ASCII", 113, 4, 7, 3},
      {"gmsh_binary.vtk", "VTK legacy 2.0 binary", 23, 4, 7, 3},
      {"gmsh.mesh", "Medit ASCII", 23, 4, 1, 2},  // Gmsh writes its volume numbers there, not the physical ones
      {"vtk_5.1_ascii.vtk", "VTK legacy 5.1 ASCII", 23, 4, 7, 3},
      {"vtk_5.1_binary.vtk", "VTK legacy 5.1 binary", 23, 4, 7, 3},
      {"vtu_ascii.vtu", "VTU ASCII", 23, 4, 7, 3},
      {"vtu_base64.vtu", "VTU base64", 23, 4, 7, 3},
      {"vtu_base64_zlib_big_endian.vtu", "VTU base64, zlib", 23, 4, 7, 3},
      {"vtu_appended_raw_zlib.vtu", "VTU appended raw, zlib", 23, 4, 7, 3},
      {"vtu_appended_raw_big_endian.vtu", "VTU appended raw", 23, 4, 7, 3},
      {"vtu_appended_base64_zlib.vtu", "VTU appended base64, zlib", 23, 4, 7, 3},
  }));
  INFO(expected.file);
  const MeshFile file = read_mesh(test_dir() / "data/meshes" / expected.file);
  const TetMesh& mesh = file.mesh;
  CHECK(file.format == expected.format);
  CHECK(mesh.positions.size() == expected.vertices);
  CHECK(mesh.tets.size() == 48);
  CHECK(file.ignored.triangles == expected.triangles);

  // The boxes have flat faces through representable corners; vertices inside are rounded to float32 at worst, and
  // moving an inner vertex does not change the sum of volumes.
  auto volumes = volume_of_regions(mesh);
  CHECK(volumes.size() == 2);
  CHECK(volumes[expected.left] == Approx(1).epsilon(1e-6));
  CHECK(volumes[expected.right] == Approx(1).epsilon(1e-6));
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    double x = 0;
    for (const std::uint32_t v : mesh.tets[t]) x += mesh.positions[v][0] / 4;
    CAPTURE(t, x);
    CHECK(mesh.regions[t] == (x < 1 ? expected.left : expected.right));
  }

  const bool named = expected.format != "Gmsh 1.0 ASCII" && expected.format.starts_with("Gmsh");
  if (!named) {
    CHECK(mesh.region_names.empty());
    return;
  }
  CHECK(mesh.region_names == std::map<int, std::string>{{3, "hard"}, {7, "soft part"}});
  CHECK(mesh.groups.at("tip").size() == 1);
  CHECK(mesh.groups.at("clamp").size() == 5);  // four corners and the middle of the face
  for (const std::uint32_t v : mesh.groups.at("clamp")) CHECK(mesh.positions[v][0] == 0);
}

TEST_CASE("a cube as TetGen writes it", "[mesh_io]") {
  const MeshFile file = read_mesh(test_dir() / "data/meshes/tetgen_cube.node");
  CHECK(file.mesh.positions.size() == 27);
  auto volumes = volume_of_regions(file.mesh);
  CHECK(volumes.size() == 1);
  CHECK(volumes[12] == Approx(1).epsilon(1e-12));
  CHECK(file.mesh.groups.at("12").size() == 8);
  CHECK(file.notes == std::vector<std::string>{kHigherOrderNote});
}

namespace {

struct ExpectedCells {
  std::string file, note;
  std::size_t tets;
  double volume;
  std::vector<std::string> groups;
};

/// Enclosed by the faces, which are wound outward.
double enclosed_volume(const MeshFile& file) {
  double volume = 0;
  std::size_t begin = 0;
  for (const std::size_t end : file.faces.ends) {
    const auto at = [&](std::size_t i) { return file.mesh.positions[file.faces.corners[i]]; };
    for (std::size_t i = begin + 1; i + 1 < end; ++i)
      volume += signed_volume6(Eigen::Vector3d::Zero(), at(begin), at(i), at(i + 1)) / 6;
    begin = end;
  }
  return volume;
}

}  // namespace

TEST_CASE("cells of all kinds as Gmsh, VTK, meshio and CalculiX write them", "[mesh_io]") {
  const auto expected = GENERATE(values<ExpectedCells>({
      {"gmsh_hexahedra.msh", "4 hexahedra split into 24 tets.", 24, 2, {"base", "brick"}},
      {"gmsh_hexahedra.mesh", "4 hexahedra split into 24 tets.", 24, 2, {"1"}},
      {"gmsh_wedges.vtk", "8 wedges split into 24 tets.", 24, 2, {"5"}},
      {"gmsh_hexahedra.inp", "4 hexahedra split into 24 tets.", 24, 2, {"Surface1", "Volume1", "base", "brick"}},
      {"gmsh_tets.inp", "", 18, 0.006, {"Surface1", "Volume1", "clamp", "tissue"}},
      {"gmsh_tets10.inp", kHigherOrderNote, 18, 0.006, {"Surface1", "Volume1", "clamp", "tissue"}},
      {"meshio_hexahedra.vtu", "4 hexahedra split into 24 tets.", 24, 2, {"5"}},
      {"meshio_mixed.vtu", "1 hexahedron, 1 wedge, 1 pyramid split into 11 tets.", 11, 1 + 0.5 + 1. / 3, {}},
      {"meshio_mixed.vtk", "1 hexahedron, 1 wedge, 1 pyramid split into 11 tets.", 11, 1 + 0.5 + 1. / 3, {}},
      {"meshio_mixed.inp", "1 hexahedron, 1 wedge split into 9 tets.", 9, 1.5, {}},
      {"cgx_hexahedra.inp", "8 hexahedra split into 48 tets.", 48, 0.006, {"Eall", "Nall"}},
      {"vtk_voxels.vtu", "4 hexahedra split into 24 tets.", 24, 4, {}},
  }));
  INFO(expected.file);
  const MeshFile file = read_mesh(test_dir() / "data/meshes" / expected.file);
  const TetMesh& mesh = file.mesh;
  CHECK(mesh.tets.size() == expected.tets);
  double volume = 0;
  for (const auto& [region, part] : volume_of_regions(mesh)) volume += part;
  CHECK(volume == Approx(expected.volume).epsilon(1e-6));
  std::vector<std::string> groups;
  for (const auto& [name, vertices] : mesh.groups) groups.push_back(name);
  CHECK(groups == expected.groups);
  if (!expected.note.empty()) CHECK(std::count(file.notes.begin(), file.notes.end(), expected.note) == 1);
  if (mesh.groups.contains("clamp")) CHECK(mesh.groups.at("clamp").size() >= 5);
}

// A box of 0.1 x 0.2 x 0.3 by Gmsh: 12 vertices, 20 triangles; the programs read its STL file.
TEST_CASE("a surface as Gmsh, admesh, assimp, meshio and VTK write it", "[mesh_io]") {
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(test_dir() / "data/meshes/surfaces")) {
    const std::string name = entry.path().filename().string();
    const MeshFile file = read_mesh_content(name, read_file(entry.path()));
    INFO(name << ": " << file.format);
    CHECK(file.is_surface());
    CHECK(file.mesh.positions.size() == (name.starts_with("assimp") ? 60 : 12));  // assimp leaves the corners apart
    CHECK(file.ignored.triangles == 20);
    CHECK(enclosed_volume(file) == Approx(0.006).epsilon(1e-6));
    CHECK(file.notes.empty());
    ++files;
  }
  CHECK(files == 20);
}
