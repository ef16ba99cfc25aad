#include "app/bench/accuracy/problem.h"

#include <cmath>
#include <limits>

#include "app/bench/beam.h"
#include "sim/mesh/mesh_generate.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

const Vector3d kSize(1, 0.25, 0.25);                    // [m], the beam of bent_beam()
constexpr double kPatchBegin = 0.9, kPatchShift = 0.3;  // [m]

Model beam_model(const AccuracyCase& measured) {
  Model model;
  model.file_mesh = make_box(measured.cells.x(), measured.cells.y(), measured.cells.z(), kSize);
  model.rest_positions = model.file_mesh.positions;
  model.tets = model.file_mesh.tets;
  model.tet_material.assign(model.tets.size(), 0);
  model.materials.resize(1);
  model.materials.front().young_modulus = measured.young_modulus;
  model.materials.front().poisson_ratio = measured.poisson_ratio;
  model.materials.front().density = 1000;
  model.initial_velocity.assign(model.rest_positions.size(), Vector3d::Zero());
  for (std::uint32_t v = 0; v < model.rest_positions.size(); ++v)
    if (model.rest_positions[v].x() == 0) model.fixed.push_back(v);
  return model;
}

// The whole end block moves as one, so that the nearest of several equilibria is unambiguous.
Motion pulled_end(const Model& model, double duration) {
  Motion motion;
  for (std::uint32_t v = 0; v < model.rest_positions.size(); ++v)
    if (model.rest_positions[v].x() > kPatchBegin - 1e-6) motion.vertices.push_back(v);
  motion.translate = {0, 0, kPatchShift};
  motion.duration = duration;
  return motion;
}

// A bar across the beam, which goes down and along it, and the ground.
std::vector<Tool> pressing_tools() {
  constexpr double kRadius = 0.06, kStart = 0.25 + kRadius, kDepth = 0.03, kWay = 0.02, kTime = 0.2;  // [m], [s]
  Tool bar, ground;
  bar.name = "bar";
  bar.shape = CapsuleShape{{0, 0, -0.1}, {0, 0, 0.35}, kRadius};
  bar.friction = 0.3;
  bar.path = {{0, {0.6, kStart, 0}, {0, 0, 0}}, {kTime, {0.6 + kWay, kStart - kDepth, 0}, {0, 0, 0}}};
  ground.name = "ground";
  ground.shape = PlaneShape{{0, 0, 0}, {0, 1, 0}};
  ground.friction = 0.3;
  ground.path = {{}};
  return {ground, bar};
}
constexpr int kStepsBefore = 8;  // of `pressed`, exact ones: 0.13 s, in which both are met

Model model_of(const AccuracyCase& measured, const SolverSettings& settings) {
  Model model = beam_model(measured);
  if (measured.scenario == AccuracyScenario::pressed) model.tools = pressing_tools();
  if (measured.scenario == AccuracyScenario::grabbed) model.motions.push_back(pulled_end(model, settings.time_step));
  return model;
}

// The result of inertia, gravity and the prescribed motion alone within a step.
std::vector<Vector3d> prediction_of(const Model& model, const State& state, const SolverSettings& settings) {
  const double h = settings.substep();
  std::vector<Vector3d> predicted = state.displacement;
  const std::vector<char> held = model.held();
  for (std::size_t v = 0; v < predicted.size(); ++v) {
    Vector3d velocity = state.velocity[v];
    for (int s = 0; s < settings.substeps && !held[v]; ++s) {
      velocity += h * model.gravity;
      predicted[v] += h * velocity;
    }
  }
  for (const Motion& motion : model.motions)
    for (std::size_t k = 0; k < motion.vertices.size(); ++k) {
      const std::uint32_t v = motion.vertices[k];
      predicted[v] =
          motion.position(k, model.rest_positions[v], state.time + settings.time_step) - model.rest_positions[v];
    }
  return predicted;
}

}  // namespace

AccuracyProblem::AccuracyProblem(const Bench& bench, const AccuracyCase& measured, int steps) : steps_(steps) {
  // The exact solver ignores the number of iterations
  const SolverSettings settings = settings_of(measured, solver_choices().front(), 1);
  model_ = model_of(measured, settings);
  start_ = measured.scenario == AccuracyScenario::one_step ? bent_beam(model_) : initial_state(model_);
  reference::NewtonSolver solver(model_, settings);
  const auto advance = [&](State& state, int count) {
    for (int step = 0; step < count; ++step) {
      bench.stop_if_interrupted();
      converged_ = solver.step(state).converged && converged_;
    }
  };
  if (measured.scenario == AccuracyScenario::pressed) advance(start_, kStepsBefore);
  exact_ = start_;
  advance(exact_, steps_);
  const bool settled = measured.scenario == AccuracyScenario::settled;
  const std::vector<Vector3d> far = settled ? std::vector<Vector3d>(start_.displacement.size(), Vector3d::Zero())
                                            : prediction_of(model_, start_, settings);
  scale_ = squared_distance(exact_.displacement, far);
}

double AccuracyProblem::error(const State& state) const {
  const double error = std::sqrt(squared_distance(state.displacement, exact_.displacement) / scale_);
  return std::isfinite(error) ? error : std::numeric_limits<double>::quiet_NaN();
}

std::vector<std::string> AccuracyProblem::notes(const AccuracyGrid& grid) {
  return {
      "beam of 1 m x 0.25 m x 0.25 m, held at x = 0, density 1000 kg/m^3, under gravity; iterations: of each substep",
      "one_step: a step from a smooth bend and twist at rest; error: RMS |x - x_exact| over RMS |x_exact - x~|, x~ "
      "where inertia and gravity alone lead",
      "grabbed: a step from rest in which the vertices with x >= 0.9 m are moved by 0.3 m along z; error as of "
      "one_step",
      "pressed: the step after " + std::to_string(kStepsBefore) +
          " exact ones from rest, in which a bar of radius 0.06 m across the beam, friction 0.3, presses it onto the "
          "ground and slides; methods that carry contact; error as of one_step",
      "settled: " + std::to_string(grid.settled_steps) +
          " steps from rest; error: RMS |x - x_exact| over RMS |x_exact - X| after the last one, x_exact stepped by "
          "the exact solver in the same steps",
      "error nan: not finite; larger numbers of iterations of the same step are not tried then",
      "ms_median, ms_min: wall time of one step from the start, all its substeps, over " +
          std::to_string(grid.repetitions) + " repetitions in which the pairs take turns; empty: not timed",
      "chebyshev finds its spectral radius within a single step; in settled it keeps that of the steps before"};
}

}  // namespace fascia
