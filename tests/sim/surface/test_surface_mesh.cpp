// Wavefront .obj: polygons of any shape, materials and colors, and one line about unreadable content.
// Covers: obj_materials
#include <catch2/catch.hpp>

#include "base/error.h"
#include "sim/surface/surface_mesh.h"
#include "tests/support/support.h"

using namespace fascia;

TEST_CASE(
    "names of materials and libraries may contain spaces, a line may name several libraries, and a color may be "
    "missing") {
  const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  const auto library = [](const std::string& name) -> std::string {
    if (name == "Left Kidney.mtl") return "newmtl Mat 1  \nKd 1 0 0\nnewmtl plain\nNs 10\n";
    if (name == "a.mtl") return "newmtl a\nKd 0 1 0\n";
    if (name == "b.mtl") return "newmtl b\nKd 0 0 1\n";
    throw Error(name, "does not exist", "");
  };
  const SurfaceMesh spaced = read_obj_content(
      "a.obj", "mtllib Left Kidney.mtl\n" + triangle + "usemtl Mat 1\nf 1 2 3\nusemtl plain\nf 1 2 3\n", library);
  CHECK(spaced.notes.empty());
  CHECK(spaced.colors == std::vector<std::uint32_t>{0xff0000ff, 0xff0000ff, 0xff0000ff, 0, 0, 0});
  const SurfaceMesh several =
      read_obj_content("a.obj", "mtllib a.mtl b.mtl\n" + triangle + "usemtl b\nf 1 2 3\n", library);
  CHECK(several.colors == std::vector<std::uint32_t>(3, 0xffff0000));
  const SurfaceMesh unknown = read_obj_content("a.obj", "mtllib a.mtl\n" + triangle + "usemtl c\nf 1 2 3\n", library);
  REQUIRE(unknown.notes.size() == 1);
  CHECK(unknown.notes[0] == "material c is in none of its libraries: drawn without it");
  CHECK(unknown.colors.empty());
}

TEST_CASE("colors of vertices from 0 to 255 are noted and read as such") {
  const SurfaceMesh mesh = read_obj_content("a.obj", "v 0 0 0 255 0 0\nv 1 0 0 255 128 0\nv 0 1 0 0 0 0\nf 1 2 3\n");
  CHECK(mesh.colors == std::vector<std::uint32_t>{0xff0000ff, 0xff0080ff, 0xff000000});
  REQUIRE(mesh.notes.size() == 1);
  CHECK(mesh.notes[0] == "colors of vertices above 1: read as 0 to 255");
}

TEST_CASE("colors come from the vertices, else from the materials, else there are none") {
  const std::string quad = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
  const auto library = [](const std::string& name) -> std::string {
    if (name != "organ.mtl") throw Error(name, "does not exist", "");
    return "newmtl red\nKd 1 0 0\nmap_Kd skin.png\nnewmtl grey\r\nKd 0.5 0.5 0.5\r\n";
  };
  CHECK(read_obj_content("a.obj", quad + "f 1 2 3 4\n", library).colors.empty());

  const SurfaceMesh painted =
      read_obj_content("a.obj", "mtllib organ.mtl\n" + quad + "usemtl red\nf 1 2 3\nusemtl grey\nf 1 3 4\n", library);
  CHECK(painted.colors ==
        std::vector<std::uint32_t>{0xff0000ff, 0xff0000ff, 0xff0000ff, 0xff808080, 0xff808080, 0xff808080});
  REQUIRE(painted.materials.size() == 2);
  CHECK(painted.materials[1].name == "grey");
  CHECK(painted.materials[1].triangles == 1);

  const SurfaceMesh partly =
      read_obj_content("a.obj", "mtllib organ.mtl\n" + quad + "f 1 2 3\nusemtl red\nf 1 3 4\n", library);
  CHECK(partly.colors == std::vector<std::uint32_t>{0, 0, 0, 0xff0000ff, 0xff0000ff, 0xff0000ff});

  const SurfaceMesh missing = read_obj_content("a.obj", "mtllib none.mtl\n" + quad + "usemtl red\nf 1 2 3\n", library);
  CHECK(missing.colors.empty());
  CHECK(missing.notes == std::vector<std::string>{"none.mtl: does not exist: drawn without its materials"});

  const SurfaceMesh vertices =
      read_obj_content("a.obj", "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\nf 1 2 3\n", library);
  CHECK(vertices.colors == std::vector<std::uint32_t>{0xff0000ff, 0xff00ff00, 0xffff0000});
}

TEST_CASE("several shapes are one surface; an unreadable file gives one line") {
  const SurfaceMesh two =
      read_obj_content("a.obj", "o one\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\no two\nv 0 0 1\nf 1/1/1 2//2 4\n");
  CHECK(two.triangles == std::vector<Triangle>{{0, 1, 2}, {0, 1, 3}});
  const auto reading = [](const std::string& text) { return read_obj_content("a.obj", text); };
  CHECK_THROWS_WITH(reading("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n"), "a.obj:4: a face uses vertex 9; expected 1 to 3");
  CHECK_THROWS_WITH(reading("v 0 0 0\n"), "a.obj: has no faces; expected a Wavefront .obj surface");
  for (const char* word : {"nan", "-nan(ind)", "inf", "0,5", "abc", "1x"})
    CHECK_THROWS_WITH(reading("v 0 0 0\nv +1 1e-3 .5 0.5\nv 0 " + std::string(word) + " 0\nf 1 2 3\n"),
                      "a.obj:3: a vertex has '" + std::string(word) + "'; expected three finite coordinates");
  CHECK_THROWS_WITH(reading("v 0 0\n"), "a.obj:1: a vertex has too few numbers; expected three finite coordinates");
  std::string large = "v 0 0 0\nf";
  for (int i = 0; i < 256; ++i) large += " 1";
  CHECK_THROWS_WITH(reading(large), "a.obj:2: a face has 256 corners; expected at most 255: cut it into triangles");
}
