// Hexahedra, wedges and pyramids as tets that fit together; formats that are told apart from meshes.
// Covers: foreign_formats, mesh_formats
#include "sim/mesh/io/cell_split.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <numeric>
#include <random>

#include "base/file.h"
#include "sim/mesh/io/foreign_formats.h"
#include "sim/mesh/io/formats.h"
#include "sim/mesh/io/mesh_formats.h"
#include "sim/mesh/mesh_check.h"
#include "sim/mesh/tet_faces.h"
#include "tests/support/meshes/samples.h"

using namespace fascia;
using namespace fascia::test;

namespace {

double volume_of(const TetMesh& mesh) {
  double volume = 0;
  for (const Tet& t : mesh.tets)
    volume +=
        signed_volume6(mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]], mesh.positions[t[3]]) / 6;
  return volume;
}

std::size_t inverted(const TetMesh& mesh) {
  return static_cast<std::size_t>(std::count_if(mesh.tets.begin(), mesh.tets.end(), [&](const Tet& t) {
    const auto& x = mesh.positions;
    return signed_volume6(x[t[0]], x[t[1]], x[t[2]], x[t[3]]) <= 0;
  }));
}

/// A block of n^3 cubes whose vertices have shuffled numbers; every third cube is two wedges, every fourth of the
/// others six pyramids.
MeshFile mixed_block(int n, std::uint32_t seed) {
  MeshFile file;
  std::vector<std::uint32_t> number(static_cast<std::size_t>((n + 1) * (n + 1) * (n + 1) + n * n * n));
  std::iota(number.begin(), number.end(), 0u);
  std::shuffle(number.begin(), number.end(), std::mt19937(seed));
  file.mesh.positions.assign(number.size(), Eigen::Vector3d::Zero());
  const auto corner = [&](int x, int y, int z) {
    const std::uint32_t v = number[static_cast<std::size_t>((z * (n + 1) + y) * (n + 1) + x)];
    file.mesh.positions[v] = {double(x), double(y), double(z)};
    return v;
  };
  std::size_t middle = static_cast<std::size_t>((n + 1) * (n + 1) * (n + 1));
  int cube = 0;
  for (int z = 0; z < n; ++z) {
    for (int y = 0; y < n; ++y) {
      for (int x = 0; x < n; ++x, ++cube, ++middle) {
        const std::array<std::uint32_t, 8> c = {
            corner(x, y, z),     corner(x + 1, y, z),     corner(x + 1, y + 1, z),     corner(x, y + 1, z),
            corner(x, y, z + 1), corner(x + 1, y, z + 1), corner(x + 1, y + 1, z + 1), corner(x, y + 1, z + 1)};
        const std::uint32_t m = number[middle];
        file.mesh.positions[m] = {x + 0.5, y + 0.5, z + 0.5};
        if (cube % 4 == 3) {
          for (const auto& f :
               {std::array{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}})
            add_solid(file, std::array{c[std::size_t(f[0])], c[std::size_t(f[1])], c[std::size_t(f[2])],
                                       c[std::size_t(f[3])], m});
        } else {
          add_solid(file, c);
        }
      }
    }
  }
  return file;
}

}  // namespace

TEST_CASE("cells become tets of the same volume that share faces, whatever the numbers of their vertices") {
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    const MeshFile file = mixed_block(3, seed);
    CAPTURE(seed, file.mesh.tets.size());
    CHECK(file.split.hexahedra == 21);
    CHECK(file.split.pyramids == 36);
    CHECK(file.split.tets == 21 * 6 + 36 * 2);
    CHECK(inverted(file.mesh) == 0);
    CHECK(volume_of(file.mesh) == Approx(27).epsilon(1e-12));
    // Neighbors that disagreed about a diagonal would leave their faces on the boundary.
    const std::vector<Triangle> boundary = boundary_triangles(file.mesh.tets);
    CHECK(boundary.size() == 6 * 9 * 2);
  }
}

TEST_CASE("each order of a cell's corner numbers gives a valid split, alone and with a neighbor") {
  std::array<std::uint32_t, 6> order = {0, 1, 2, 3, 4, 5};
  std::size_t cells = 0;
  do {
    MeshFile file;
    file.mesh.positions.resize(7);
    const Eigen::Vector3d places[6] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
    for (std::size_t i = 0; i < 6; ++i) file.mesh.positions[order[i]] = places[i];
    file.mesh.positions[6] = {2, 2, 0.5};
    REQUIRE(add_solid(file, order) == 3);
    REQUIRE(add_solid(file, std::array{order[1], order[2], order[5], order[4], 6u}) == 2);
    REQUIRE(inverted(file.mesh) == 0);
    REQUIRE(boundary_triangles(file.mesh.tets).size() == 2 + 4 + 4);
    ++cells;
  } while (std::next_permutation(order.begin(), order.end()));
  CHECK(cells == 720);
}

TEST_CASE("a wedge of the other winding is turned; collapsed cells become fewer tets or are counted") {
  MeshFile file;
  file.mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
  CHECK(add_solid(file, std::array{3u, 4u, 5u, 0u, 1u, 2u}) == 3);
  CHECK(inverted(file.mesh) == 0);
  CHECK(volume_of(file.mesh) == Approx(0.5));
  CHECK(add_solid(file, std::array{0u, 1u, 2u, 2u, 3u, 4u, 5u, 5u}) == 3);  // a hexahedron that is a wedge
  CHECK(volume_of(file.mesh) == Approx(1));
  CHECK(inverted(file.mesh) == 0);
  CHECK(add_solid(file, std::array{0u, 0u, 0u, 0u, 1u, 1u, 1u, 1u}) == 0);
  CHECK(file.ignored.others == 1);
  add_face(file, std::array{0u, 1u});
  add_face(file, std::array{0u, 1u, 2u});
  add_face(file, std::array{0u, 1u, 4u, 3u});
  CHECK(file.ignored.lines == 1);
  CHECK(file.ignored.triangles == 1);
  CHECK(file.ignored.polygons == 1);
  CHECK(file.faces.ends == std::vector<std::size_t>{3, 7});
}

TEST_CASE("files of other kinds are named, with a way to bring them in") {
  const auto told = [](const std::string& name, const std::string& content) { return error_of(name, content); };
  CHECK(told("a.bdf", "SOL 101\nCEND\nBEGIN BULK\nGRID,1,,0.,0.,0.\n") ==
        "a.bdf: is a Nastran deck, which fascia does not read; Gmsh converts it: gmsh FILE -save -format msh41 -o "
        "OUT.msh");
  CHECK(told("a.dat", "$ Created by Gmsh\nGRID           1\nCTETRA\n").starts_with("a.dat: is a Nastran deck"));
  CHECK(told("a.key", "$# comment\n*KEYWORD\n").starts_with("a.key: is an LS-DYNA keyword file"));
  CHECK(told("a.dat", "SOL 101\nGRID           1\n").starts_with("a.dat: is a Nastran deck"));
  CHECK(told("a.xdmf", "<?xml version=\"1.0\"?><!DOCTYPE Xdmf SYSTEM \"Xdmf.dtd\" []>\n<Xdmf Version=\"3.0\"></Xdmf>")
            .starts_with("a.xdmf: is an XDMF mesh"));
  CHECK(told("a.k", "*KEYWORD\n*NODE\n").starts_with("a.k: is an LS-DYNA keyword file"));
  const std::pair<const char*, std::string> others[] = {
      {"a.exo", std::string("CDF\1\0\0", 6)},
      {"a.e", "\x89HDF\r\n\x1a\n"},
      {"a.med", "\x89HDF\r\n\x1a\n"},
      {"a.usda", "#usda 1.0\n"},
      {"a.usdc", "PXR-USDC"},
      {"a.nrrd", "NRRD0004\n"},
      {"a.nii.gz", "\x1f\x8b\x08"},
      {"a.stl.gz", "\x1f\x8b\x08"},
      {"a.zip", "PK\3\4"},
      {"a.hdr", std::string(344, ' ') + std::string("ni1\0", 4)},
      {"a.stp", "ISO-10303-21;\n"},
      {"a.igs", "                                                                        S      1\n"},
      {"a.blend", "BLENDER-v300"},
      {"a.fbx", "Kaydara FBX Binary  "},
      {"a.glb", std::string("glTF\2\0\0\0", 8)},
      {"a.gltf", "{\"asset\": {}}"},
      {"a.meshb", std::string("\1\0\0\0\3\0\0\0", 8)}};
  for (const auto& [name, content] : others) {
    const std::string text = error_of(name, content);
    INFO(text);
    CHECK(text.starts_with(std::string(name) + ": is a"));
    CHECK(text.find(", which fascia does not read; ") != std::string::npos);
  }
  CHECK_FALSE(foreign_format("12 3 4\n", ".txt"));
  CHECK(std::string(foreign_format("\x89HDF", ".med")->name) == "a MED mesh");
}

TEST_CASE("the table of formats has every ending that is read or written, once") {
  std::vector<std::string> endings = tet_endings();
  const std::vector<std::string> surfaces = surface_endings();
  endings.insert(endings.end(), surfaces.begin(), surfaces.end());
  std::vector<std::string> once = endings;
  std::sort(once.begin(), once.end());
  CHECK(std::adjacent_find(once.begin(), once.end()) == once.end());
  CHECK(written_endings() == std::vector<std::string>{".msh", ".vtk", ".vtu", ".node", ".ele", ".mesh", ".inp"});
  CHECK(ten_node_endings() == std::vector<std::string>{".msh", ".vtk", ".vtu", ".inp"});
  for (const std::string& ending : written_endings())
    CHECK(std::find(endings.begin(), endings.end(), ending) != endings.end());
  CHECK(listed_formats().starts_with("Gmsh .msh, VTK .vtk .vtu, "));
}
