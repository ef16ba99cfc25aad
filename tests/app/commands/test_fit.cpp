// fascia fit fits what fascia run wrote.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/system/spawned_program.h"
#include "base/file.h"
#include "sim/scene/scene.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

namespace {

const std::string kYoung = "materials.default.young_modulus", kPoisson = "materials.default.poisson_ratio";

TEST_CASE("fit finds the values that made a shape, and writes its files", "[fit]") {
  const TemporaryFolder folder;
  const std::string shape = (folder / "shape.csv").string(), out = (folder / "out").string();
  REQUIRE(run_fascia({"run", cube_path(), "--static", "--reference", "--set", kYoung + "=30000", "--set",
                      kPoisson + "=0.35", "--export", shape, "--quiet"})
              .exit_code == 0);
  const CommandResult result = run_fascia(
      {"fit", cube_path(), "--static", "--measured", shape, "--free", kYoung + "," + kPoisson, "--out", out});
  INFO(result.out << result.err);
  REQUIRE(result.exit_code == 0);
  CHECK(result.out.find(kYoung + "  30000 Pa") != std::string::npos);
  CHECK(result.out.find("rates by implicit differentiation") != std::string::npos);
  CHECK(result.err.find("fascia: simulation 2: misfit ") != std::string::npos);
  const auto json = nlohmann::json::parse(read_file(folder / "out/fit.json"));
  CHECK(json["parameters"][0]["value"].get<double>() == Approx(30000).epsilon(1e-6));
  CHECK(json["simulations"].get<int>() <= 12);
  const Scene fitted = open_scene(folder / "out/scene.json");
  CHECK(fitted.bodies[0].material.poisson_ratio == Approx(0.35).epsilon(1e-6));
  CHECK(run_fascia({"run", out + "/scene.json", "--steps", "1", "--reference", "--quiet"}).exit_code == 0);
  // Of vertices, too, a fit without residuals has a profile over a tenth of the value, and ends once it is exact.
  CHECK(read_file(folder / "out/report.html").find("Up to a tenth of the value or of its range") != std::string::npos);
}

TEST_CASE("fit finds the values that made a history", "[fit]") {
  const TemporaryFolder folder;
  const std::string history = (folder / "history.csv").string();
  const std::string damping = "materials.default.damping";
  REQUIRE(run_fascia({"run", cube_path(), "--reference", "--steps", "20", "--set", kYoung + "=30000", "--set",
                      damping + "=0.03", "--history", history, "--quiet"})
              .exit_code == 0);
  const CommandResult result =
      run_fascia({"fit", cube_path(), "--set", damping + "=0.02", "--measured", history + ",2", "--free", kYoung,
                  "--free", damping, "--columns", "reaction,probe", "--profile", "0", "--quiet"});
  INFO(result.out << result.err);
  REQUIRE(result.exit_code == 0);
  CHECK(result.err.empty());
  CHECK(result.out.find(kYoung + "  30000 Pa") != std::string::npos);
  CHECK(result.out.find("rates by implicit differentiation") != std::string::npos);
}

// Incompressible uniaxial tension has the nominal stress 2 (l - 1/l^2) (c10 + c01/l) (Mooney 1940, Rivlin 1948). Its
// least squares to the same forces are c10 = 0.11999 and c01 = 0.07604 MPa: 1.176 MPa and a ratio of 0.388.
TEST_CASE("fit finds the constants of rubber from a published measurement", "[fit]") {
  const std::filesystem::path assets = source_dir() / "assets/fit";
  const TemporaryFolder folder;
  const CommandResult result =
      run_fascia({"fit", (assets / "rubber.json").string(), "--static", "--measured",
                  (assets / "treloar_1944.csv").string(), "--free", kYoung + ",materials.default.mooney_ratio",
                  "--profile", "0", "--out", (folder / "out").string(), "--quiet"});
  INFO(result.out << result.err);
  REQUIRE(result.exit_code == 0);
  const auto json = nlohmann::json::parse(read_file(folder / "out/fit.json"));
  const double young = json["parameters"][0]["value"], ratio = json["parameters"][1]["value"];
  CHECK(young < 1.176e6);  // clamped ends stiffen the specimen
  CHECK(young > 0.93 * 1.176e6);
  CHECK(ratio == Approx(0.388).margin(0.01));
  CHECK(json["simulations"].get<int>() <= 12);
}

TEST_CASE("fit simulates on the GPU where it is told to", "[fit]") {
  const TemporaryFolder folder;
  const std::string history = (folder / "history.csv").string();
  REQUIRE(run_fascia({"run", cube_path(), "--reference", "--steps", "10", "--set", kYoung + "=30000", "--history",
                      history, "--quiet"})
              .exit_code == 0);
  const CommandResult result =
      run_fascia({"fit", cube_path(), "--gpu", "--context", "osmesa", "--measured", history, "--free", kYoung,
                  "--columns", "probe", "--profile", "0", "--out", (folder / "out").string()});
  INFO(result.out << result.err);
  REQUIRE(result.exit_code == 0);
  CHECK(result.out.find("rates by differences") != std::string::npos);
  const auto json = nlohmann::json::parse(read_file(folder / "out/fit.json"));
  CHECK(json["parameters"][0]["value"].get<double>() == Approx(30000).epsilon(1e-3));
}

TEST_CASE("a fit that is killed goes on with the same command, and another one is refused", "[fit]") {
  const TemporaryFolder folder;
  const std::string history = (folder / "history.csv").string(), out = (folder / "out").string();
  REQUIRE(run_fascia({"run", cube_path(), "--reference", "--steps", "100", "--set", kYoung + "=9000", "--history",
                      history, "--quiet"})
              .exit_code == 0);
  const std::vector<std::string> same = {"fit",    cube_path(), "--measured", history, "--columns", "probe",
                                         "--free", kYoung,      "--profile",  "0",     "--out",     out};
  const std::filesystem::path record = folder / "out/progress.json";
  {
    std::vector<std::string> command = same;
    command.insert(command.begin(), FASCIA_BINARY);
    SpawnedProgram killed(command);
    const auto better = [&] {  // than the start
      return std::filesystem::exists(record) && nlohmann::json::parse(read_file(record))["simulations"] > 1;
    };
    while (!better() && !killed.ended()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    REQUIRE_FALSE(killed.ended());
  }
  std::vector<std::string> other = same;
  other.insert(other.end(), {"--set", "materials.default.density=900"});
  const CommandResult refused = run_fascia(other);
  INFO(refused.err);
  CHECK(refused.exit_code != 0);
  CHECK(refused.err.find("is of an interrupted fit with another scene") != std::string::npos);

  const CommandResult rest = run_fascia(same);
  INFO(rest.out << rest.err);
  CHECK(rest.exit_code == 0);
  CHECK(rest.err.find("fascia: goes on after ") != std::string::npos);
  CHECK(rest.out.find(kYoung + "  9000 Pa") != std::string::npos);
  CHECK_FALSE(std::filesystem::exists(record));
}

TEST_CASE("fit says what is wrong, with its exit code", "[fit]") {
  const TemporaryFolder folder;
  const auto file = [&](const std::string& name, const std::string& content) {
    write_file(folder / name, content);
    return (folder / name).string();
  };
  const std::string weight = file("weight.csv", "reaction_y_N\n9.81\n");
  const auto fit = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"fit", cube_path(), "--static", "--quiet"});
    return run_fascia(more);
  };
  const CommandResult unit = fit({"--measured", file("unit.csv", "reaction_y_lbf\n1\n"), "--free", kYoung});
  CHECK(unit.exit_code == 1);
  CHECK(unit.err.find("unit.csv:1: column reaction_y_lbf has the unit \"lbf\"; expected N, mN, kN") !=
        std::string::npos);
  const CommandResult key = fit({"--measured", weight, "--free", "materials.default.young_modulos"});
  CHECK(key.exit_code == 2);
  CHECK(key.err.find("--free materials.default.young_modulos: unknown key") != std::string::npos);
  const CommandResult noise = fit({"--measured", weight, "--free", kYoung, "--noise", "3lbf"});
  CHECK(noise.exit_code == 2);
  CHECK(noise.err.find("--noise 3lbf: is no noise; expected a share or an amount") != std::string::npos);
  const CommandResult prior = fit({"--measured", weight, "--free", kYoung, "--prior", kYoung + "=1e4:1e3"});
  CHECK(prior.exit_code == 2);
  CHECK(prior.err.find("expected --noise beside it") != std::string::npos);
  CHECK(fit({"--measured", weight}).exit_code == 2);
  CHECK(fit({"--free", kYoung}).exit_code == 2);
  // Weight alone says nothing about stiffness.
  const CommandResult undetermined = fit({"--measured", weight, "--free", kYoung});
  INFO(undetermined.out << undetermined.err);
  CHECK(undetermined.exit_code == 1);
  CHECK(undetermined.err.find("not converged: the measurement (reaction_y) does not depend on " + kYoung) !=
        std::string::npos);
}

}  // namespace
