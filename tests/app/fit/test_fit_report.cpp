// Covers: fit_text, fit_charts
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/charts/gnuplot.h"
#include "app/fit/fit_charts.h"
#include "app/fit/fit_report.h"
#include "app/fit/fit_text.h"
#include "base/error.h"
#include "base/file.h"
#include "sim/fit/simulated/reference_simulator.h"
#include "tests/support/support.h"

using namespace fascia;

namespace {

std::vector<Measurement> measured() {
  Measurement pull{"folder/pull.csv", 1, {}, {}, {}};
  pull.curves = {{"support_1_x", {Measurand::Kind::support, 1, 0}, Dimension::force, {0.5, 1}, {1, 2}, 0.02},
                 {"support_1_y", {Measurand::Kind::support, 1, 1}, Dimension::force, {0.5, 1}, {0, 0.5}, 0.02},
                 {"vertex_3_y", {Measurand::Kind::vertex, 3, 1}, Dimension::length, {}, {0.01}, 1e-4}};
  Measurement shape{"shape.csv", 1, {}, {{{4}, {{0, 0, 0}}, 1e-3}}, {}};
  return {pull, shape};
}

FitResult result() {
  FitResult r;
  r.converged = true;
  r.simulated = Eigen::VectorXd(8);
  r.simulated << 1.01, 2.02, 0.01, 0.5, 0.0102, 1e-4, -2e-4, 0;
  r.estimates.parameters = {{"materials.default.young_modulus", 12000, 11000, 13000, 0.02, true},
                            {"materials.default.poisson_ratio", 0.4, -0.9, 0.499, 0, false}};
  r.estimates.correlation = Eigen::Matrix2d::Identity();
  r.estimates.correlation(0, 1) = r.estimates.correlation(1, 0) = -0.5;
  r.estimates.warnings = {"the measurement <alone> cannot tell"};
  r.misfit = 1.5;
  r.start_misfit = 15;
  r.simulations = 6;
  r.profile_simulations = 4;
  r.exact_rates = true;
  r.profiles = {{0, {11000, 12000, 13000}, {1.7, 1.5, 1.8}}};
  r.scene.bodies.emplace_back().name = "block";
  r.scene.bodies[0].mesh = "block.msh";
  r.scene.title = "Block & pull";
  return r;
}

TEST_CASE("the text of a fit has values, intervals, correlations, effort and warnings", "[fit]") {
  const std::string text = fit_text(result(), false);
  INFO(text);
  CHECK(
      text ==
      "materials.default.young_modulus  12000 Pa   95 %: 11000 to 13000\n"
      "materials.default.poisson_ratio  0.4   95 %: not determined\n"
      "correlation -0.5: materials.default.young_modulus, materials.default.poisson_ratio\n"
      "residual 1.5 % of the largest values, at the start 15 % of the largest values; 6 simulations (rates by implicit "
      "differentiation), 4 for the profile\n"
      "warning: the measurement <alone> cannot tell\n");
  CHECK(misfit_text(1.5, true) == "1.5 times the noise");
  CHECK(interval_text({"a", 1, std::nan(""), std::nan(""), 0, true}) == "unknown");
  CHECK(unit_of("materials.stiff.density") == "kg/m^3");
  CHECK(unit_of("gravity.1").empty());
}

TEST_CASE("a chart shows measured marks and the simulated curve of each component", "[fit]") {
  const ReferenceSimulator reference;
  const Experiment experiment(measured(), true, 0, reference);
  const std::vector<NamedChart> charts = curve_charts(experiment, result().simulated);
  REQUIRE(charts.size() == 1);  // a single value is no curve
  CHECK(charts[0].name == "1_support_1");
  CHECK(charts[0].chart.title == "pull.csv: support_1");
  CHECK(charts[0].chart.y.label == "force [N]");
  REQUIRE(charts[0].chart.series.size() == 4);
  CHECK(charts[0].chart.series[0].name == "x measured");
  CHECK(charts[0].chart.series[0].points[1] == Eigen::Vector2d(1, 2));
  CHECK(!charts[0].chart.series[0].line);
  CHECK(charts[0].chart.series[1].points[1] == Eigen::Vector2d(1, 2.02));
  CHECK(charts[0].chart.series[3].points[0] == Eigen::Vector2d(0.5, 0.01));

  const std::vector<NamedChart> profiles = profile_charts(result(), false);
  REQUIRE(profiles.size() == 1);
  CHECK(profiles[0].chart.title == "Misfit along materials.default.young_modulus, 3 standard errors");
  FitResult exact = result();
  exact.profiles[0].of_errors = false;
  CHECK(profile_charts(exact, false)[0].chart.title ==
        "Misfit along materials.default.young_modulus, a tenth at either side");
  CHECK(profiles[0].chart.x.label == "materials.default.young_modulus [Pa]");
  CHECK(profiles[0].chart.series[0].points[0] == Eigen::Vector2d(11000, 1.7));
}

TEST_CASE("the files of a fit", "[fit]") {
  const fascia::test::TemporaryFolder folder;
  const ReferenceSimulator reference;
  const Experiment experiment(measured(), true, 0, reference);
  make_fit_folder(folder / "fit");
  write_fit(folder / "fit", result(), {experiment, false, "fascia fit a.json"});
  const std::string report = read_file(folder / "fit/report.html");
  CHECK(report.find("Fit: Block &amp; pull") != std::string::npos);
  CHECK(report.find("the measurement &lt;alone&gt; cannot tell") != std::string::npos);
  CHECK(report.find("not determined") != std::string::npos);
  CHECK(report.find("<td>pull.csv</td><td class=\"n\">support_1_x</td><td class=\"n\">2</td><td "
                    "class=\"n\">0.01581</td><td class=\"n\">0.02</td>") != std::string::npos);
  CHECK((report.find("image/svg+xml") != std::string::npos) == gnuplot_installed());
  const auto json = nlohmann::json::parse(read_file(folder / "fit/fit.json"));
  CHECK(json["parameters"][0]["interval_95"] == nlohmann::json::array({11000, 13000}));
  CHECK(!json["parameters"][1].contains("interval_95"));
  CHECK(json["correlation"][0][1] == -0.5);
  CHECK(read_file(folder / "fit/values.csv")
            .starts_with("file,quantity,time_s,measured,simulated\npull.csv,support_1_x_N,0.5,1,1.01\n"));
  CHECK(read_file(folder / "fit/values.csv").find("pull.csv,vertex_3_y_m,,0.01,0.0102\n") != std::string::npos);
  CHECK(read_file(folder / "fit/scene.json").find("\"Block & pull\"") != std::string::npos);
  write_file(folder / "file", "");
  CHECK_THROWS_WITH(make_fit_folder(folder / "file/fit"), Catch::Contains("expected a folder for the output"));
}

}  // namespace
