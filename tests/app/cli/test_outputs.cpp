// Outputs of a command are checked before it works, and invalid results are not written.
// Covers: output_files, sim/simulation/static_equilibrium, app/video/frame_sink
#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/cli/output_files.h"
#include "app/cli/usage_error.h"
#include "base/error.h"
#include "sim/mesh/io/mesh_io.h"
#include "sim/model/vertex_csv.h"
#include "tests/support/support.h"

namespace fascia {
namespace {

namespace fs = std::filesystem;
using Catch::Matchers::Contains;
using test::CommandResult;
using test::run_fascia;
using test::TemporaryFolder;

std::string content_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream out;
  out << in.rdbuf();
  return out.str();
}

}  // namespace

TEST_CASE("outputs that cannot be written, or would destroy another file, are refused", "[outputs]") {
  const TemporaryFolder folder;
  const std::string here = folder.path().string() + "/";
  std::ofstream(here + "mesh.msh") << "a mesh";
  const auto refusal = [](const std::vector<OutputFile>& outputs, const std::vector<fs::path>& inputs = {}) {
    try {
      require_outputs(outputs, inputs);
    } catch (const UsageError& error) {
      return std::string("usage: ") + error.what();
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(refusal({{"--a", here + "x.csv", {".vtu", ".csv"}}, {"--b", here + "y.json", {}}, {"--c", "", {}}},
                {here + "mesh.msh"})
            .empty());
  CHECK(refusal({{"--a", here + "X.CSV", {".csv"}}}).empty());
  CHECK(refusal({{"--a", "/dev/null", {".csv"}}, {"--b", "/dev/null", {}}}).empty());
  CHECK_THAT(refusal({{"--a", here + "x.stl", {".vtu", ".csv"}}}),
             Contains("usage: --a") && Contains("x.stl") && Contains("expected .vtu or .csv"));
  CHECK_THAT(refusal({{"--a", here + "no/x.csv", {}}}), Contains("no such folder") && !Contains("usage"));
  CHECK_THAT(refusal({{"--a", here, {}}}), Contains("is a directory"));
  CHECK_THAT(refusal({{"--a", here + "x.csv", {}}, {"--b", here + "./x.csv", {}}}),
             Contains("usage: --b") && Contains("is the file of --a"));
  CHECK_THAT(refusal({{"--a", here + "mesh.msh", {}}}, {here + "mesh.msh"}),
             Contains("usage: --a") && Contains("is a file that is read"));
  fs::create_symlink(here + "mesh.msh", here + "link.msh");
  CHECK_THAT(refusal({{"--a", here + "link.msh", {}}}, {here + "mesh.msh"}), Contains("is a file that is read"));
}

TEST_CASE("run checks all of its outputs before the first step", "[outputs]") {
  const TemporaryFolder folder;
  const std::string stats = (folder.path() / "stats.json").string();
  CommandResult result =
      run_fascia({"run", cube_path(), "--steps", "2", "--stats", stats, "--export", "/no/such/folder/x.csv"});
  CAPTURE(result.err);
  CHECK(result.exit_code == 1);
  CHECK_THAT(result.err, Contains("no such folder"));
  CHECK_FALSE(fs::exists(stats));
  result = run_fascia({"run", cube_path(), "--steps", "2", "--export", (folder.path() / "x.stl").string()});
  CHECK(result.exit_code == 2);
  const fs::path mesh = folder.path() / "mesh.msh";
  fs::copy(test::source_dir() / "assets/meshes/cube.msh", mesh);
  const std::string before = content_of(mesh);
  result = run_fascia({"run", mesh.string(), "--steps", "2", "--export", mesh.string()});
  CHECK(result.exit_code == 2);
  CHECK(content_of(mesh) == before);
}

TEST_CASE("no input of a scene or a conversion is overwritten", "[outputs]") {
  const TemporaryFolder folder;
  const auto copy_of = [&](const char* asset, const char* name) {
    fs::copy(test::source_dir() / asset, folder.path() / name, fs::copy_options::overwrite_existing);
    return (folder.path() / name).string();
  };
  const std::string mesh = copy_of("assets/meshes/cube.msh", "cube.msh");
  REQUIRE(run_fascia({"run", mesh, "--steps", "0", "--export", (folder.path() / "values.csv").string(), "--quiet"})
              .exit_code == 0);
  REQUIRE(run_fascia({"run", mesh, "--steps", "0", "--export", (folder.path() / "skin.obj").string(), "--quiet"})
              .exit_code == 0);
  const std::string body = "{\"fascia_scene\": 1, \"bodies\": [{\"mesh\": \"cube.msh\", ";
  std::ofstream(folder / "velocity.json") << body << "\"initial_velocity\": \"values.csv\"}]}";
  std::ofstream(folder / "targets.json") << body << "\"prescribed\": [{\"targets\": \"values.csv\"}]}]}";
  std::ofstream(folder / "skin.json") << body << "\"surface\": \"skin.obj\"}]}";
  for (const auto& [scene, file] : {std::pair("velocity.json", "values.csv"), std::pair("targets.json", "values.csv"),
                                    std::pair("skin.json", "skin.obj")}) {
    const fs::path read = folder.path() / file;
    const std::string before = content_of(read);
    const CommandResult result =
        run_fascia({"run", (folder.path() / scene).string(), "--steps", "1", "--export", read.string()});
    CAPTURE(scene, result.err);
    CHECK(result.exit_code == 2);
    CHECK_THAT(result.err, Contains("is a file that is read"));
    CHECK(content_of(read) == before);
  }

  const std::string before = content_of(mesh);
  CHECK(run_fascia({"convert", mesh, mesh}).exit_code == 2);
  CHECK(content_of(mesh) == before);
  const std::string node = (folder.path() / "cube.node").string(), ele = (folder.path() / "cube.ele").string();
  REQUIRE(run_fascia({"convert", mesh, node}).exit_code == 0);
  CHECK(run_fascia({"convert", node, ele}).exit_code == 2);

  const std::string state = (folder.path() / "state.csv").string();
  const CommandResult both = run_fascia({"run", mesh, "--steps", "1", "--export", state, "--stats", state + ".json"});
  CAPTURE(both.err);
  CHECK(both.exit_code == 2);
}

TEST_CASE("a picture never overwrites the golden that it is compared with", "[outputs]") {
  const TemporaryFolder folder;
  const fs::path golden = folder.path() / "golden.png";
  const std::vector<std::string> render{"render", cube_path(), "--steps", "1",
                                        "--size", "64x48",     "--out",   golden.string()};
  REQUIRE(run_fascia(render).exit_code == 0);
  const std::string before = content_of(golden);
  std::vector<std::string> compare = render;
  compare[5] = "80x60";
  compare.insert(compare.end(), {"--compare", golden.string()});
  const CommandResult result = run_fascia(compare);
  CAPTURE(result.err);
  CHECK(result.exit_code == 2);
  CHECK(content_of(golden) == before);
  CHECK(run_fascia({"render", cube_path(), "--steps", "1", "--out", (folder.path() / "picture.jpg").string()})
            .exit_code == 2);
}

TEST_CASE("a static equilibrium on the GPU is the reference solver's, unless a tolerance is given", "[outputs]") {
  const TemporaryFolder folder;
  const fs::path reference = test::source_dir() / "tests/reference/02_cantilever_large";
  const std::vector<Eigen::Vector3d> rest = read_mesh(reference / "mesh.msh").mesh.positions;
  const auto equilibrium = [&](const std::vector<std::string>& options) {
    const fs::path state = folder.path() / "state.csv";
    std::vector<std::string> arguments{
        "run", (reference / "scene.json").string(), "--static", "--quiet", "--export", state.string()};
    arguments.insert(arguments.end(), options.begin(), options.end());
    REQUIRE(run_fascia(arguments).exit_code == 0);
    return read_complete_vertex_csv(state, rest.size());
  };
  const std::vector<Eigen::Vector3d> exact = equilibrium({"--reference"});
  const auto error = [&](const std::vector<Eigen::Vector3d>& found) {
    double largest = 0, way = 0;
    for (std::size_t v = 0; v < rest.size(); ++v) {
      largest = std::max(largest, (found[v] - exact[v]).norm());
      way = std::max(way, (exact[v] - rest[v]).norm());
    }
    return largest / way;
  };
  const double refined = error(equilibrium({"--context", "osmesa"}));
  const double asked = error(equilibrium({"--context", "osmesa", "--set", "solver.tolerance=1e-5"}));
  CAPTURE(refined, asked);
  CHECK(refined < 1e-7);  // a residual of 1e-10; in slender bodies errors are some thousand residuals
  CHECK(asked > refined);
}

TEST_CASE("a state that did not come to rest is no static equilibrium", "[outputs]") {
  const TemporaryFolder folder;
  const fs::path state = folder.path() / "state.csv";
  const CommandResult result =
      run_fascia({"run", (test::source_dir() / "assets/scenes/cube.json").string(), "--static", "--set",
                  "materials.default.young_modulus=10", "--set", "materials.default.model=signed_st_venant_kirchhoff",
                  "--export", state.string()});
  CAPTURE(result.err);
  CHECK(result.exit_code == 1);
  CHECK_THAT(result.err, Contains("no static equilibrium after") && Contains("relative residual"));
  CHECK_FALSE(fs::exists(state));
}

TEST_CASE("a body that topples for a long time is followed to its equilibrium", "[outputs]") {
  // Fixed at its lower end, the kidney topples; that takes some hundred iterations in which the residual hardly
  // changes.
  const TemporaryFolder folder;
  const fs::path stats = folder.path() / "stats.json";
  const CommandResult result = run_fascia(
      {"run", (test::source_dir() / "assets/meshes/kidney.obj").string(), "--static", "--stats", stats.string()});
  CAPTURE(result.err);
  REQUIRE(result.exit_code == 0);
  const double residual = nlohmann::json::parse(content_of(stats)).at("residual");
  CAPTURE(residual);
  CHECK(residual <= 1e-5);
}

TEST_CASE("numbers of options are finite, and meaningless ones are refused", "[outputs]") {
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{{"--time", "nan"},
                                                                                         {"--time", "inf"},
                                                                                         {"--steps", "-5"},
                                                                                         {"--time", "0.001"},
                                                                                         {"--static", "--steps", "3"},
                                                                                         {"--static", "--time", "1"}}) {
    std::vector<std::string> all{"run", cube_path()};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const CommandResult result = run_fascia(all);
    CAPTURE(arguments, result.err);
    CHECK(result.exit_code == 2);
    CHECK(result.err.size() < 200);
  }
}

TEST_CASE("the solver choice that a single name selects is reported", "[outputs]") {
  const CommandResult result = run_fascia({"run", cube_path(), "--steps", "1", "--set", "solver.acceleration=chebyshev",
                                           "--set", "materials.default.model=signed_st_venant_kirchhoff"});
  CAPTURE(result.err);
  CHECK(result.exit_code == 0);
  CHECK_THAT(result.err, Contains("solver: mass_splitting + chebyshev"));
}

}  // namespace fascia
