// The errors that fascia run --error measures and estimates.
// Covers: run
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "base/file.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

TEST_CASE("run --error compares the last step with the exact one", "[cli]") {
  const TemporaryFolder folder;
  const std::string stats = (folder / "stats.json").string();
  const auto error = [&](const std::string& iterations) {
    const CommandResult result = run_fascia({"run", cube_path(), "--steps", "5", "--context", "osmesa", "--stats",
                                             stats, "--error", "--set", "solver.iterations=" + iterations});
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    CHECK(result.err.find("error of the last step") != std::string::npos);
    return nlohmann::json::parse(read_file(stats)).at("error").get<double>();
  };
  const double few = error("2"), many = error("100");
  CAPTURE(few, many);
  CHECK(few > 1e-3);
  CHECK(few < 1);
  CHECK(many < 1e-4);
}

TEST_CASE("run --error tells the errors of solver, time step and mesh apart", "[cli]") {
  const std::string mesh = (source_dir() / "tests/reference/10_dynamic_cantilever/scene.json").string();
  const auto errors = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"run", mesh, "--context", "osmesa", "--error", "--stats", "-"});
    const CommandResult result = run_fascia(more);
    CAPTURE(result.err);
    REQUIRE(result.exit_code == 0);
    CHECK(result.err.find("of the displacement: ") != std::string::npos);
    return nlohmann::json::parse(result.out).at("errors");
  };
  const nlohmann::json euler = errors({"--steps", "20"}),
                       bdf2 = errors({"--steps", "20", "--set", "solver.integrator=bdf2"}),
                       still = errors({"--static"}), exact = errors({"--steps", "2", "--reference"});
  CAPTURE(euler.dump(), bdf2.dump(), still.dump(), exact.dump());
  CHECK(euler.at("solver").get<double>() < 1e-3);
  CHECK(euler.at("time").get<double>() > 5 * bdf2.at("time").get<double>());
  CHECK(euler.at("mesh").get<double>() > 0.02);  // 4,963 linear tets of a beam that bends
  CHECK(euler.at("mesh").get<double>() < 0.5);
  CHECK(euler.at("peak_stress").at("mesh").get<double>() > 0);
  const double recovered = euler.at("peak_stress").at("recovered_Pa"), tets = euler.at("peak_stress").at("tets_Pa");
  CHECK(tets > 1000);  // of a beam of 2.5e5 Pa that is strained by some percent
  CHECK(recovered != tets);
  CHECK(recovered == Approx(tets).epsilon(0.2));
  CHECK_FALSE(still.contains("solver"));
  CHECK_FALSE(still.contains("time"));
  CHECK(still.contains("mesh"));
  CHECK_FALSE(exact.contains("solver"));
  CHECK(exact.contains("time"));
}
