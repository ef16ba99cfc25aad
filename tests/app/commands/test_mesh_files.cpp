// Meshes on the command line: through a pipe, welded on request, and their reports.
// Covers: convert, info
#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdio>
#include <fstream>
#include <thread>

#include "base/file.h"
#include "sim/mesh/io/mesh_io.h"
#include "sim/mesh/mesh_generate.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

namespace {

/// A box whose tets all have vertices of their own, in a region with a name.
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

TEST_CASE("Ctrl+C ends a command that waits for its input, with exit code 130", "[mesh_files]") {
  const TemporaryFolder folder;
  int number = 0;
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"info"}, {"convert"}, {"run", "--steps", "1"}}) {
    const std::string pipe = (folder / ("pipe" + std::to_string(number++))).string(),
                      out = (folder / "out.vtk").string();
    REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
    std::vector<const char*> argv{FASCIA_BINARY};
    for (const std::string& argument : arguments) argv.push_back(argument.c_str());
    argv.push_back(pipe.c_str());
    if (arguments[0] == "convert") argv.push_back(out.c_str());
    argv.push_back(nullptr);
    const pid_t child = fork();
    if (child == 0) {
      execv(argv[0], const_cast<char**>(argv.data()));
      _exit(127);
    }
    const int writer = open(pipe.c_str(), O_WRONLY);  // blocks until the command reads
    REQUIRE(writer >= 0);
    kill(child, SIGINT);
    int status = 0;
    waitpid(child, &status, 0);
    close(writer);
    std::printf("%s: exit code %d\n", arguments[0].c_str(),
                WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status));
    CHECK(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 130);
    CHECK_FALSE(std::filesystem::exists(out));
  }
}

TEST_CASE("an input that is no file or has no data is a one-line error", "[mesh_files]") {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "folder.msh");
  for (const std::string name : {"x.msh", "x.obj", "x.vtk", "x.vtu", "x.mesh", "x.node"}) {
    write_file(folder / name, name == "x.msh" ? "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n" : "");
    std::filesystem::resize_file(folder / name, std::uintmax_t{10} << 30);
  }
  for (const std::string& name :
       {std::string("x.msh"), std::string("x.obj"), std::string("x.vtk"), std::string("x.vtu"), std::string("x.mesh"),
        std::string("x.node"), std::string("folder.msh"), std::string("/dev/zero")}) {
    const CommandResult result = run_fascia({"info", name}, folder.path());
    std::printf("%s", result.err.c_str());
    CHECK(result.exit_code == 1);
    CHECK(std::count(result.err.begin(), result.err.end(), '\n') == 1);
    CHECK_THAT(result.err, Catch::StartsWith(name + ": ") || Catch::StartsWith("./" + name + ": "));
  }
}

TEST_CASE("tets with vertices of their own are reported and welded", "[mesh_files]") {
  const TemporaryFolder folder;
  const std::string apart = (folder / "apart.vtk").string(), whole = (folder / "whole.mesh").string();
  write_mesh(apart, soup());
  const CommandResult told = run_fascia({"info", apart});
  CHECK_THAT(told.out, Catch::Contains("48, 36 of them at the place of an earlier one"));
  CHECK_THAT(told.out, Catch::Contains("of each of its 12 pieces") && !Catch::Contains("unconstrained"));
  const CommandResult welded = run_fascia({"convert", apart, whole, "--weld"});
  INFO(welded.err);
  CHECK(welded.exit_code == 0);
  CHECK_THAT(welded.err, Catch::Contains("36 vertices at the place of an earlier one left out"));
  CHECK_THAT(welded.err,
             Catch::Contains(".mesh holds the numbers of regions, no names and no groups. Left out: region 3 liver."));
  CHECK(read_mesh(whole).mesh.positions.size() == 12);
  CHECK_THAT(run_fascia({"info", whole}).out, Catch::Contains("components  1\n") && !Catch::Contains("unconstrained"));
}

TEST_CASE("convert keeps quadratic tets, those of its own files and of exports", "[mesh_files]") {
  const TemporaryFolder folder;
  const std::string first = (test_dir() / "data/meshes/gmsh_tets10.inp").string();
  const MeshFile file = read_mesh(first);
  std::string from = first;
  for (const std::string ending : {".inp", ".vtu", ".msh", ".vtk"}) {
    const std::string to = (folder / ("copy" + ending)).string();
    const CommandResult result = run_fascia({"convert", from, to});
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    const std::string tets = std::to_string(file.mesh.tets.size());
    CHECK_THAT(result.err,
               Catch::Contains(tets + " tets (" + tets + " quadratic)") && !Catch::Contains("elements=quadratic"));
    const MeshFile copy = read_mesh(to);
    CHECK(copy.mesh.tets == file.mesh.tets);
    CHECK(copy.mid_edges == file.mid_edges);
    CHECK(copy.mesh.positions.size() == file.mesh.positions.size());
    from = to;
  }
  const std::string corners = (folder / "corners.mesh").string();
  const CommandResult cut = run_fascia({"convert", from, corners});
  CHECK(cut.exit_code == 0);
  CHECK_THAT(cut.err, Catch::Contains("written with the corners alone") && !Catch::Contains("quadratic)"));
  CHECK(read_mesh(corners).mid_edges.empty());

  const std::string exported = (folder / "exported.vtu").string(), inp = (folder / "exported.inp").string();
  const CommandResult run = run_fascia({"run", from, "--set", "elements=quadratic", "--steps", "0", "--export",
                                        exported, "--quiet", "--context", "osmesa"});
  INFO(run.err);
  REQUIRE(run.exit_code == 0);
  REQUIRE(run_fascia({"convert", exported, inp}).exit_code == 0);
  CHECK(read_mesh(inp).mid_edges == read_mesh(exported).mid_edges);
  CHECK(read_mesh(inp).mid_edges.size() == file.mesh.tets.size());
}

TEST_CASE("convert says which cells of a file it does not write", "[mesh_files]") {
  const TemporaryFolder folder;
  const std::string boxes = (test_dir() / "data/meshes/gmsh_2.2_binary.msh").string();
  const CommandResult result = run_fascia({"convert", boxes, (folder / "out.vtk").string()});
  INFO(result.err);
  CHECK(result.exit_code == 0);
  CHECK_THAT(result.err,
             Catch::Contains("fascia: not written, beside the tets: 1 point, 4 triangles; groups keep their "
                             "vertices\n"));
}
