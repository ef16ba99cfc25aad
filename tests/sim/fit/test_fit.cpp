// Round trips: a scene is simulated with known values, noise is added, and the fit finds the values again.
#include <catch2/catch.hpp>

#include "base/error.h"
#include "base/suggest.h"
#include "sim/fit/simulated/in_parallel.h"
#include "tests/sim/fit/block_scene.h"

namespace fascia {
namespace {

using test::BlockScene;
using Kind = Measurand::Kind;

constexpr const char* kYoung = "materials.default.young_modulus";
constexpr const char* kPoisson = "materials.default.poisson_ratio";
constexpr const char* kStiff = "materials.stiff.young_modulus";
constexpr const char* kDamping = "materials.default.damping";

// A vertex at the side of the block's middle, which moves inward as the block is stretched.
std::uint32_t side_vertex(const Model& model) {
  std::uint32_t best = 0;
  const Eigen::Vector3d wanted(test::kBlockLength / 2, 0.04, 0.02);
  for (std::uint32_t v = 0; v < model.rest_positions.size(); ++v)
    if ((model.rest_positions[v] - wanted).norm() < (model.rest_positions[best] - wanted).norm()) best = v;
  return best;
}

MeasuredCurve force(int count) { return test::curve_of("support_1_x", {Kind::support, 1, 0}, test::moments(count, 1)); }
MeasuredCurve narrowing(const Model& model, int count) {
  return test::curve_of("vertex_y", {Kind::vertex, side_vertex(model), 1}, test::moments(count, 1));
}

FitResult fitted(const Scene& start, std::vector<Measurement> measurements, const std::vector<std::string>& keys,
                 bool is_static = true, FitOptions options = {}, const std::vector<Noise>& noise = {}) {
  const Model model = build_model(start);
  options.noise_known = !noise.empty();
  assign_noise(measurements, noise, model);
  const TunedScene tuned(start, model, parameters_of(start, keys));
  const Experiment experiment(measurements, is_static, start.duration, test::kReference);
  return fit(tuned, experiment, options);
}

FitOptions without_profile() {
  FitOptions options;
  options.profile = 0;
  return options;
}

bool holds(const Estimate& estimate, double value) { return estimate.low <= value && value <= estimate.high; }

TEST_CASE("a force curve gives Young's modulus back", "[fit]") {
  const BlockScene block;
  std::vector<Measurement> measured{{"pull.csv", 1, {force(5)}, {}, {}}};
  test::measure(measured, block.scene({std::string(kYoung) + "=5000"}), true, 0, 1);
  const FitResult result = fitted(block.scene(), measured, {kYoung});
  CAPTURE(result.simulations, result.estimates.parameters[0].value);
  CHECK(result.converged);
  CHECK(result.exact_rates);
  CHECK(result.estimates.parameters[0].value == Approx(5000).epsilon(1e-7));
  CHECK(result.scene.bodies[0].material.young_modulus == Approx(5000).epsilon(1e-7));
  CHECK(result.simulations <= 6);  // none beyond the digits of a measurement
  REQUIRE(result.profiles.size() == 1);
  const std::vector<double>& misfits = result.profiles[0].misfits;
  CHECK(std::min_element(misfits.begin(), misfits.end()) - misfits.begin() == FitOptions().profile);
  CHECK(result.profile_simulations == 2 * FitOptions().profile);
  // Without residuals there are no standard errors to go to.
  CHECK(!result.profiles[0].of_errors);
  CHECK(result.profiles[0].values.front() == Approx(5000 * std::exp(-0.1)).epsilon(1e-6));
  CHECK(result.profiles[0].values.back() == Approx(5000 * std::exp(0.1)).epsilon(1e-6));
  CHECK(misfits.front() > 1);
}

TEST_CASE("a curve in a wrong unit is told", "[fit]") {
  const BlockScene block;
  std::vector<Measurement> measured{{"folder/pull.csv", 1, {force(2)}, {}, {}}};
  test::measure(measured, block.scene(), true, 0, 0);
  for (double& value : measured[0].curves[0].values) value *= 1000;  // mN as N
  FitOptions options = without_profile();
  std::vector<std::string> said;
  options.say = [&](const std::string& line) { said.push_back(line); };
  const FitResult result = fitted(block.scene(), measured, {kYoung}, true, options);
  const std::string doubt =
      "support_1_x of pull.csv is 1000 times as large as with the scene's own values: is its unit right?";
  REQUIRE(!result.estimates.warnings.empty());
  CHECK(result.estimates.warnings.front() == doubt);
  CHECK(std::find(said.begin(), said.end(), doubt) != said.end());
}

// Known values, and how many of the intervals of `seeds` fits hold them.
struct Known {
  std::vector<std::string> keys;
  std::vector<double> values;
};
struct Coverage {
  std::vector<int> held;  // [key]
  int failed = 0;
  long simulations = 0, most = 0;
};
Coverage coverage(int seeds, const Known& known, const std::vector<Noise>& noise) {
  const BlockScene block;
  std::vector<std::string> sets;
  for (std::size_t k = 0; k < known.keys.size(); ++k)
    sets.push_back(known.keys[k] + "=" + std::to_string(known.values[k]));
  const Scene start = block.scene(), truth = block.scene(sets);
  std::vector<Measurement> exact{{"pull.csv", 1, {force(8), narrowing(build_model(start), 8)}, {}, {}}};
  test::measure(exact, truth, true, 0, 0);
  std::vector<FitResult> results(static_cast<std::size_t>(seeds));
  in_parallel(results.size(), [&](std::size_t i) {
    std::vector<Measurement> measured = exact;
    test::add_noise(measured, 0.01, static_cast<unsigned>(i) + 1);
    results[i] = fitted(start, measured, known.keys, true, without_profile(), noise);
  });
  Coverage found{std::vector<int>(known.keys.size(), 0)};
  for (const FitResult& result : results) {
    found.failed += !result.converged;
    for (std::size_t k = 0; k < known.keys.size(); ++k)
      found.held[k] += holds(result.estimates.parameters[k], known.values[k]);
    found.simulations += result.simulations;
    found.most = std::max(found.most, result.simulations);
  }
  std::vector<std::string> counts;
  for (const int held : found.held) counts.push_back(std::to_string(held));
  WARN("95 % intervals of " << join(known.keys) << " that hold the truth, of " << seeds << ": " << join(counts)
                            << (noise.empty() ? ", noise estimated" : ", noise known") << "; simulations per fit "
                            << static_cast<double>(found.simulations) / seeds << ", at most " << found.most);
  return found;
}

const Known kYoungAlone{{kYoung}, {13000}}, kYoungAndPoisson{{kYoung, kPoisson}, {13000, 0.3}};

TEST_CASE("intervals from a stretch with lateral contraction cover the truth", "[fit]") {
  const Coverage found = coverage(12, kYoungAndPoisson, {});
  CHECK(found.failed == 0);
  // Of 12 independent intervals that hold with 0.95, 9 or more do with a probability of 0.9978.
  for (const int held : found.held) CHECK(held >= 9);
  CHECK(found.most <= 12);
}

TEST_CASE("intervals of 95 % cover the truth in 95 % of 1000 seeds", "[fit][slow]") {
  const Known known = GENERATE(kYoungAlone, kYoungAndPoisson);
  const std::vector<Noise> noise = GENERATE(std::vector<Noise>{}, std::vector<Noise>{{0.01, true, Dimension::force}});
  const Coverage found = coverage(1000, known, noise);
  CHECK(found.failed == 0);
  // Of 1000 independent intervals that hold with 0.95, 932 or more do with a probability of 0.9949, and 966 or fewer
  // with one of 0.9941. If they held with 0.92, 932 or more would with one of 0.088.
  for (const int held : found.held) {
    CHECK(held >= 932);
    CHECK(held <= 966);
  }
  CHECK(found.most <= 12);
}

TEST_CASE("two materials from forces and displacements", "[fit]") {
  const BlockScene block;
  const Scene truth = block.scene({std::string(kYoung) + "=30000", std::string(kStiff) + "=40000"});
  const Model model = build_model(truth);
  std::vector<Measurement> measured{
      {"pull.csv",
       1,
       {force(6), test::curve_of("vertex_x", {Kind::vertex, side_vertex(model), 0}, test::moments(6, 1))},
       {},
       {}}};
  test::measure(measured, truth, true, 0.01, 7);
  const FitResult result = fitted(block.scene(), measured, {kYoung, kStiff});
  CAPTURE(result.simulations, result.estimates.parameters[0].value, result.estimates.parameters[1].value);
  CHECK(result.converged);
  REQUIRE(result.profiles.size() == 2);
  CHECK(result.profiles[0].of_errors);
  CHECK(holds(result.estimates.parameters[0], 30000));
  CHECK(holds(result.estimates.parameters[1], 40000));
  CHECK(result.simulations <= 12);
}

TEST_CASE("damping and stiffness from a released beam", "[fit]") {
  const BlockScene beam(R"("young_modulus": 20000, "poisson_ratio": 0.3, "damping": 0.01)", R"("duration": 0.6, )", "");
  const Scene truth = beam.scene({std::string(kYoung) + "=26000", std::string(kDamping) + "=0.02"});
  const Model model = build_model(truth);
  const auto tip = static_cast<std::uint32_t>(model.rest_positions.size() - 1);
  std::vector<Measurement> measured{
      {"swing.csv", 1, {test::curve_of("vertex_y", {Kind::vertex, tip, 1}, test::moments(40, 0.6))}, {}, {}}};
  test::measure(measured, truth, false, 0.01, 3);
  const FitResult result = fitted(beam.scene(), measured, {kYoung, kDamping}, false);
  CAPTURE(result.simulations, result.estimates.parameters[0].value, result.estimates.parameters[1].value);
  CHECK(result.converged);
  CHECK(result.exact_rates);
  CHECK(result.simulations <= 12);
  CHECK(result.estimates.parameters[0].value == Approx(26000).epsilon(0.02));
  CHECK(result.estimates.parameters[1].value == Approx(0.02).epsilon(0.1));
  CHECK(holds(result.estimates.parameters[0], 26000));
}

TEST_CASE("what a measurement cannot tell is named", "[fit]") {
  const BlockScene block;
  const Scene truth = block.scene();
  // Only the ratio of the moduli shapes a stretched block that carries no load of its own.
  const Model model = build_model(truth);
  std::vector<Measurement> measured{
      {"shape.csv",
       1,
       {test::curve_of("vertex_x", {Kind::vertex, side_vertex(model), 0}, test::moments(6, 1))},
       {},
       {}}};
  const Scene weightless = block.scene({"gravity=[0,0,0]"});
  test::measure(measured, weightless, true, 0.01, 7);
  const FitResult result = fitted(weightless, measured, {kYoung, kStiff});
  REQUIRE(!result.converged);
  CAPTURE(result.reason);
  CHECK(result.reason.find("cannot tell " + std::string(kYoung) + " from " + kStiff) != std::string::npos);
  CHECK(!result.estimates.parameters[0].determined);
  CHECK(result.reason.find("the measurement (vertex_x)") != std::string::npos);

  const FitResult density = fitted(weightless, measured, {"materials.default.density"});
  CHECK(density.reason.find("does not depend on materials.default.density") != std::string::npos);
}

TEST_CASE("a sweep finds a far start", "[fit]") {
  const BlockScene block;
  std::vector<Measurement> measured{{"pull.csv", 1, {force(3)}, {}, {}}};
  test::measure(measured, block.scene({std::string(kYoung) + "=150000", "materials.stiff.young_modulus=200000"}), true,
                0, 1);
  FitOptions options;
  options.sweep = 8;
  std::vector<std::string> lines;
  options.say = [&](const std::string& line) { lines.push_back(line); };
  const FitResult result =
      fitted(block.scene({"materials.stiff.young_modulus=200000"}), measured, {kYoung}, true, options);
  CHECK(result.estimates.parameters[0].value == Approx(150000).epsilon(1e-6));
  CHECK(lines.size() >= 3);
  CHECK(lines[1].starts_with("sweep: the best of 9 simulations"));
}

TEST_CASE("a fit goes on from the record of an earlier one", "[fit]") {
  const BlockScene block;
  std::vector<Measurement> measured{{"pull.csv", 1, {force(4)}, {}, {}}};
  test::measure(measured, block.scene({std::string(kYoung) + "=5000"}), true, 0.01, 1);
  std::vector<FitProgress> records;
  FitOptions options = without_profile();
  options.keep = [&](const FitProgress& progress) { records.push_back(progress); };
  const FitResult whole = fitted(block.scene(), measured, {kYoung}, true, options);
  REQUIRE(records.size() >= 3);
  CHECK(records.front().simulations == 1);
  options.earlier = records[1];
  records.clear();
  const FitResult rest = fitted(block.scene(), measured, {kYoung}, true, options);
  CAPTURE(whole.simulations, rest.simulations);
  CHECK(rest.converged);
  CHECK(rest.start_misfit == whole.start_misfit);
  CHECK(records.front().simulations == options.earlier->simulations + 1);  // that of its own first point
  CHECK(rest.simulations <= whole.simulations + 1);
  CHECK(rest.estimates.parameters[0].value == Approx(whole.estimates.parameters[0].value).epsilon(1e-5));
}

TEST_CASE("a fit that is stopped says so, and one of too few values is refused", "[fit]") {
  const BlockScene block;
  std::vector<Measurement> measured{{"pull.csv", 1, {force(1)}, {}, {}}};
  test::measure(measured, block.scene(), true, 0, 1);
  FitOptions options;
  std::stop_source stop;
  stop.request_stop();
  options.stop = stop.get_token();
  CHECK(fitted(block.scene(), measured, {kYoung}, true, options).interrupted);
  CHECK_THROWS_WITH(fitted(block.scene(), measured, {kYoung, kPoisson}),
                    "--free: has 2 parameters for 1 measured value; expected at least as many values");
}

}  // namespace
}  // namespace fascia
