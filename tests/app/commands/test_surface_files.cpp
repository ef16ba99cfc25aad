// A closed surface on the command line: reported, converted, simulated; one without an inside is refused in one line.
#include <catch2/catch.hpp>
#include <fstream>

#include "sim/mesh/io/mesh_io.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

namespace {

const std::string kidney = (source_dir() / "assets/meshes/kidney.obj").string();

}  // namespace

TEST_CASE("info reports a surface and the tets in it") {
  const CommandResult result = run_fascia({"info", kidney, "--set", "resolution=16"});
  INFO(result.out << result.err);
  REQUIRE(result.exit_code == 0);
  for (const char* part : {"23860", "closed      yes", "shells      5", "colors      of the vertices",
                           "filled with tets, resolution 16", "dihedral", "of them outside of the tets"})
    CHECK_THAT(result.out, Catch::Contains(part));
}

TEST_CASE("a surface converts to a mesh of tets and runs") {
  const TemporaryFolder folder;
  const std::string mesh = (folder / "kidney.msh").string();
  const CommandResult converted = run_fascia({"convert", kidney, mesh});
  INFO(converted.err);
  REQUIRE(converted.exit_code == 0);
  const std::size_t tets = read_mesh(mesh).mesh.tets.size();
  CHECK(tets > 5000);
  CHECK(tets < 10000);
  const CommandResult run =
      run_fascia({"run", kidney, "--set", "resolution=12", "--steps", "2", "--context", "osmesa", "--quiet"});
  INFO(run.err);
  CHECK(run.exit_code == 0);
}

TEST_CASE("an STL file is reported, converted and told from tets by its content") {
  const TemporaryFolder folder;
  const std::filesystem::path box = folder / "box.dat";
  std::filesystem::copy_file(test_dir() / "data/meshes/surfaces/admesh_binary.stl", box);
  const CommandResult told = run_fascia({"info", box.string(), "--set", "resolution=8"});
  INFO(told.out << told.err);
  CHECK(told.exit_code == 0);
  CHECK_THAT(told.out, Catch::Contains("format      STL binary surface") && Catch::Contains("closed      yes") &&
                           Catch::Contains("filled with tets, resolution 8"));
  const CommandResult converted = run_fascia({"convert", box.string(), (folder / "box.msh").string()});
  INFO(converted.err);
  CHECK(converted.exit_code == 0);
  CHECK(!read_mesh(folder / "box.msh").mesh.tets.empty());
}

TEST_CASE("a surface without an inside and one of several million tets are refused in one line") {
  const TemporaryFolder folder;
  const std::string sheet = (folder / "sheet.obj").string();
  std::ofstream(sheet) << "v 0 0 0\nv 0.1 0 0\nv 0.1 0 0.1\nv 0 0 0.1\nf 1 2 3 4\n";
  for (const std::string command : {"info", "run"}) {
    const CommandResult result = run_fascia({command, sheet});
    CHECK(result.exit_code == 1);
    CHECK_THAT(result.err, Catch::Contains("sheet.obj: is open: 4 edges"));
    CHECK(std::count(result.err.begin(), result.err.end(), '\n') == 1);
  }
  const CommandResult result = run_fascia({"run", kidney, "--set", "resolution=300", "--steps", "1"});
  CHECK(result.exit_code == 2);
  CHECK_THAT(result.err, Catch::Contains("2 to 256"));
}

TEST_CASE("info names the program that converts a glTF file, which is JSON like a scene") {
  const TemporaryFolder folder;
  std::ofstream(folder / "a.gltf") << "{\"asset\": {\"version\": \"2.0\"}}";
  const CommandResult info = run_fascia({"info", "a.gltf"}, folder.path());
  CHECK(info.exit_code == 1);
  CHECK(info.err.find("a.gltf: is a glTF scene, which fascia does not read; Blender imports it") != std::string::npos);
}
