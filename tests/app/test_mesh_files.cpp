// Meshes on the command line: through a pipe, welded on demand, and what is told of them.
#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <fstream>
#include <thread>

#include "sim/file.h"
#include "sim/mesh_generate.h"
#include "sim/mesh_io.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

namespace {

/// Every tet of a box with vertices of its own, in a region that has a name.
TetMesh soup() {
  const TetMesh box = make_box(1, 2, 1, {0.1, 0.2, 0.1});
  TetMesh mesh;
  for (const Tet& tet : box.tets) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const std::uint32_t v : tet) mesh.positions.push_back(box.positions[v]);
    mesh.tets.push_back({first, first + 1, first + 2, first + 3});
  }
  mesh.regions.assign(mesh.tets.size(), 3);
  mesh.region_names[3] = "liver";
  return mesh;
}

}  // namespace

TEST_CASE("info reads a mesh through a named pipe", "[mesh_files]") {
  const TemporaryFolder folder;
  REQUIRE(mkfifo((folder / "pipe").c_str(), 0600) == 0);
  const std::string content = read_file(source_dir() / "assets/meshes/cube.msh");
  std::jthread writer([&] { std::ofstream(folder / "pipe") << content; });
  const CommandResult result = run_fascia({"info", (folder / "pipe").string()});
  INFO(result.err);
  CHECK(result.exit_code == 0);
  CHECK_THAT(result.out, Catch::Contains("components  1") && Catch::Contains("coloring"));
}

TEST_CASE("tets with vertices of their own are told about and welded", "[mesh_files]") {
  const TemporaryFolder folder;
  const std::string apart = (folder / "apart.vtk").string(), whole = (folder / "whole.mesh").string();
  write_mesh(apart, soup());
  const CommandResult told = run_fascia({"info", apart});
  CHECK_THAT(told.out, Catch::Contains("48, 36 of them at the place of an earlier one"));
  CHECK_THAT(told.out, Catch::Contains("are held nowhere and will fall"));
  const CommandResult welded = run_fascia({"convert", apart, whole, "--weld"});
  INFO(welded.err);
  CHECK(welded.exit_code == 0);
  CHECK_THAT(welded.err, Catch::Contains("36 vertices at the place of an earlier one left out"));
  CHECK_THAT(welded.err, Catch::Contains(".mesh holds the numbers of regions, no names and no groups. Left out: region 3 liver."));
  CHECK(read_mesh(whole).mesh.positions.size() == 12);
  CHECK_THAT(run_fascia({"info", whole}).out, Catch::Contains("components  1\n") && !Catch::Contains("held nowhere"));
}
