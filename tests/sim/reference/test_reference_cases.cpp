// The solver against tests/reference, the exact solutions of five scenes (see the README there).
#include <catch2/catch.hpp>
#include <fstream>
#include <sstream>

#include "sim/grab/build_model.h"
#include "sim/reference/elasticity.h"
#include "sim/reference/newton.h"
#include "tests/sim/reference/box_model.h"
#include "tests/support/support.h"

namespace fascia::reference {
namespace {

using Eigen::Vector3d;
using Rows = std::vector<std::vector<double>>;

std::filesystem::path case_file(const std::string& folder, const std::string& file) {
  return test::test_dir() / "reference" / folder / file;
}

Rows read_numbers(const std::filesystem::path& path) {
  std::ifstream in(path);
  std::string line, cell;
  Rows rows;
  std::getline(in, line);  // header
  while (std::getline(in, line)) {
    std::istringstream cells(line);
    rows.emplace_back();
    while (std::getline(cells, cell, ',')) rows.back().push_back(std::stod(cell));
  }
  return rows;
}

/// RMS distance to the positions of `file` over their RMS displacement; over all vertices, as in compare.py.
double relative_error(const Model& model, const State& state, const std::filesystem::path& file) {
  const Rows rows = read_numbers(file);
  REQUIRE(rows.size() == state.displacement.size());
  double error = 0, displacement = 0;
  for (std::size_t v = 0; v < rows.size(); ++v) {
    const Vector3d expected = Vector3d(rows[v][1], rows[v][2], rows[v][3]) - model.rest_positions[v];
    error += (state.displacement[v] - expected).squaredNorm();
    displacement += expected.squaredNorm();
  }
  return std::sqrt(error / displacement);
}

// The references are accurate to 1e-10 of the RMS displacement at least (case.json, "crosscheck"); so is a residual of
// 1e-10.
constexpr double tolerance = 1e-9;

Measures check_static(const std::string& folder, double elastic_energy) {
  const Model model = build_model(open_scene(case_file(folder, "scene.json")));
  State state = initial_state(model);
  const NewtonReport report = NewtonSolver(model, {}).solve_static(state);
  const double error = relative_error(model, state, case_file(folder, "reference.csv"));
  const Measures measures = measure(model, state);
  CAPTURE(folder, report.iterations, report.relative_residual, error, measures.elastic);
  CHECK(report.converged);
  CHECK(error < tolerance);
  CHECK(measures.elastic == Approx(elastic_energy).epsilon(1e-9));
  return measures;
}

// Energies, reactions and ranges of det F: "elastic_energy_J", "reactions_N", "min_det_F" of each case.json.
TEST_CASE("reference case 01: cantilever, small deflection", "[reference]") {
  const Measures measures = check_static("01_cantilever_small", 0.04650242004165686);
  CHECK((measures.fixed_reaction - Vector3d(0, 39.24, 0)).norm() < 1e-9 * 39.24);
}

TEST_CASE("reference case 02: cantilever, large deflection", "[reference]") {
  const Measures measures = check_static("02_cantilever_large", 1.0692078235381277);
  CHECK((measures.fixed_reaction - Vector3d(0, 39.24, 0)).norm() < 1e-9 * 39.24);
  CHECK(measures.min_det_f == Approx(0.8153432516340197).epsilon(1e-8));
  CHECK(measures.max_det_f == Approx(1.1432300563282134).epsilon(1e-8));
}

TEST_CASE("reference case 05: bar stretched by half", "[reference]") {
  const Measures measures = check_static("05_stretch_150", 41.84095027744022);
  CHECK(measures.fixed_reaction.norm() < 1e-9 * 1018);  // both ends together: 1018.7 N against -1018.7 N
  CHECK(measures.min_det_f == Approx(0.9274849791530253).epsilon(1e-8));
}

TEST_CASE("reference case 09a: affine compression, with the pressure of the closed form", "[reference]") {
  const Measures measures = check_static("09a_affine_compression", 1.791230751800402);
  CHECK(measures.min_det_f == Approx(0.8).epsilon(1e-9));
  CHECK(measures.max_det_f == Approx(0.8).epsilon(1e-9));

  const Model model = build_model(open_scene(case_file("09a_affine_compression", "scene.json")));
  State state = initial_state(model);
  NewtonSolver(model, {}).solve_static(state);
  const StateFields fields = export_fields(model, state);
  double worst_shear = 0, worst_pressure = 0;
  for (std::size_t t = 0; t < model.tets.size(); ++t) {
    const auto& strain = fields.green_strain[model.tet_source[t]];
    const double stretch = std::sqrt(1 + 2 * strain[0]);
    const double first_piola =
        second_piola_stress(strain[0] * Eigen::Matrix3d::Identity(), model.materials[0])(0, 0) * stretch;
    worst_pressure = std::max(worst_pressure, std::abs(-first_piola / (stretch * stretch) - 18612.447286673247));
    worst_shear = std::max(worst_shear, fields.von_mises[model.tet_source[t]]);
  }
  CAPTURE(worst_pressure, worst_shear);
  CHECK(worst_pressure < 1e-8 * 18612);
  CHECK(worst_shear < 1e-8 * 18612);
}

// About 400 Newton iterations on 4963 tets: the longest test here.
TEST_CASE("reference case 10: cantilever released from rest", "[reference][heavy]") {
  const std::string folder = "10_dynamic_cantilever";
  Scene scene = open_scene(case_file(folder, "scene.json"));
  const Model model = build_model(scene);
  const Rows history = read_numbers(case_file(folder, "history_h60.csv"));
  REQUIRE(history.size() == 61);
  SolverSettings settings;
  settings.time_step = 1.0 / 60;
  NewtonSolver solver(model, settings);
  State state = initial_state(model);
  const std::size_t tip = 857;
  for (int step = 1; step <= 60; ++step) {
    const NewtonReport report = solver.step(state);
    const Measures measures = measure(model, state);
    const std::vector<double>& row = history[step];  // step, t, P, L, kinetic, elastic, gravity potential, tip
    CAPTURE(step, report.iterations, report.relative_residual);
    REQUIRE(report.converged);
    CHECK(state.time == Approx(row[1]).epsilon(1e-13));
    // Momenta oscillate through zero: the scale is their size over the run, about 1.8 kg m/s and 0.6 kg m^2/s.
    CHECK((measures.momentum - Vector3d(row[2], row[3], row[4])).norm() < 1.8 * tolerance);
    CHECK((measures.angular_momentum - Vector3d(row[5], row[6], row[7])).norm() < 0.6 * tolerance);
    CHECK(measures.kinetic == Approx(row[8]).epsilon(10 * tolerance));
    CHECK(measures.elastic == Approx(row[9]).epsilon(tolerance));
    const Vector3d tip_position = model.rest_positions[tip] + state.displacement[tip];
    CHECK((tip_position - Vector3d(row[11], row[12], row[13])).norm() < 0.14 * tolerance);
    if (step == 1 || step == 10 || step == 30 || step == 60) {
      const double error =
          relative_error(model, state, case_file(folder, "reference_h60_step" + std::to_string(step) + ".csv"));
      CAPTURE(error);
      CHECK(error < tolerance);
    }
  }
}

// The stored positions of BDF2 come from another program; the continuous ones from steps of 1/3840 s.
TEST_CASE("reference case 10 with other integrators", "[reference][heavy]") {
  const auto [integrator, error_in_time] = GENERATE(table<Integrator, double>(
      {{Integrator::implicit_euler, 0.238}, {Integrator::bdf2, 0.0320}, {Integrator::sdirk2, 0.0094}}));
  const std::string folder = "10_dynamic_cantilever";
  const Model model = build_model(open_scene(case_file(folder, "scene.json")));
  SolverSettings settings;
  settings.integrator = integrator;
  NewtonSolver solver(model, settings);
  State state = initial_state(model);
  for (int step = 0; step < 60; ++step) REQUIRE(solver.step(state).converged);
  const double to_truth = relative_error(model, state, case_file(folder, "reference_continuous_t1.csv"));
  CAPTURE(name_of(integrator), to_truth);
  CHECK(to_truth == Approx(error_in_time).epsilon(0.01));
  if (integrator != Integrator::bdf2) return;
  const double to_stored = relative_error(model, state, case_file(folder, "reference_bdf2_h60_step60.csv"));
  CAPTURE(to_stored);
  CHECK(to_stored < tolerance);
}

}  // namespace
}  // namespace fascia::reference
