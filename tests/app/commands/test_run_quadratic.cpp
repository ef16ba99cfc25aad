// fascia run with quadratic tets: exports that have their cells, and the refusal of the GPU solver.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "base/file.h"
#include "sim/mesh/io/mesh_io.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

namespace {}  // namespace

TEST_CASE("run exports quadratic tets as cells of ten nodes", "[run]") {
  const std::string ending = GENERATE(".vtu", ".msh");
  const TemporaryFolder folder;
  const std::string file = (folder / ("out" + ending)).string();
  const CommandResult run =
      run_fascia({"run", cube_path(), "--reference", "--steps", "1", "--set", "elements=quadratic", "--export", file});
  CAPTURE(run.err, ending);
  REQUIRE(run.exit_code == 0);
  const MeshFile read = read_mesh(file);
  const MeshFile linear = read_mesh(source_dir() / "assets/meshes/cube.msh");
  CHECK(read.mesh.tets == linear.mesh.tets);
  REQUIRE(read.mid_edges.size() == read.mesh.tets.size());
  CHECK(read.mesh.positions.size() > 4 * linear.mesh.positions.size());
  double farthest = 0;  // the state's edges are bent, by less than they are long
  for (std::size_t t = 0; t < read.mid_edges.size(); ++t)
    for (std::size_t m = 0; m < 6; ++m) {
      const auto& x = read.mesh.positions;
      const auto [a, b] = kMidEdgeCorners[m];
      const Eigen::Vector3d from = x[read.mesh.tets[t][a]], to = x[read.mesh.tets[t][b]];
      farthest = std::max(farthest, (x[read.mid_edges[t][m]] - 0.5 * (from + to)).norm() / (to - from).norm());
    }
  CHECK(farthest < 0.05);
}

TEST_CASE("quadratic tets run on the GPU as exactly as linear ones, and other methods refuse them in one line",
          "[run]") {
  const TemporaryFolder folder;
  const std::filesystem::path stats = folder / "stats.json";
  const CommandResult run = run_fascia({"run", cube_path(), "--steps", "5", "--quiet", "--set", "elements=quadratic",
                                        "--error", "--stats", stats.string()});
  INFO(run.err);
  REQUIRE(run.exit_code == 0);
  const nlohmann::json numbers = nlohmann::json::parse(read_file(stats));
  CHECK(numbers.at("error").get<double>() < 2e-3);
  CHECK(numbers.at("inverted") == 0);
  const CommandResult refused = run_fascia({"run", cube_path(), "--steps", "1", "--quiet", "--set",
                                            "elements=quadratic", "--set", "solver.method=vertex_descent"});
  CHECK(refused.exit_code == 1);
  CHECK(refused.err == cube_path() +
                           ": solver.method: vertex_descent does not carry quadratic elements; expected two_level, or "
                           "bodies with linear "
                           "elements\n");
}
