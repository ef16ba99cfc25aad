#include "app/bench/figures/beam_step.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "app/bench/beam.h"
#include "sim/grab/build_model.h"

namespace fascia {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

SolverSettings settings_of(const SolverChoice& pair, int iterations) {
  SolverSettings settings;
  settings.method = pair.method;
  settings.acceleration = pair.acceleration;
  settings.iterations = iterations;
  return settings;
}

// The result of inertia and gravity alone.
std::vector<Eigen::Vector3d> prediction_of(const Model& model, const State& state, double h) {
  std::vector<Eigen::Vector3d> predicted = state.displacement;
  const std::vector<char> held = model.held();
  for (std::size_t v = 0; v < predicted.size(); ++v)
    if (!held[v]) predicted[v] += h * state.velocity[v] + h * h * model.gravity;
  return predicted;
}

}  // namespace

BeamStep::BeamStep(Bench& bench, double young_modulus, int iterations)
    : scene_(beam_scene(bench, young_modulus, settings_of(i3d2019_choices().front(), iterations))),
      model_(build_model(scene_)),
      start_(bent_beam(model_)),
      exact_(start_),
      predicted_(prediction_of(model_, start_, scene_.solver.substep())) {
  reference::NewtonSolver(model_, scene_.solver).step(exact_);
  exact_strain_ = reference::measure(model_, exact_).rms_strain;
  for (const SolverChoice& pair : i3d2019_choices()) {
    bench.stop_if_interrupted();
    PairTrace traced{
        pair, std::make_unique<GpuSolver>(*bench.graphics.programs, model_, settings_of(pair, iterations)), {}, 0};
    traced.solver->upload(start_);
    traced.trace = traced.solver->traced_substep();
    traced.error = error(traced.solver->download());
    pairs_.push_back(std::move(traced));
  }
}

std::size_t BeamStep::plain() const {
  const auto plain = std::find_if(pairs_.begin(), pairs_.end(), [](const PairTrace& p) {
    return p.pair == SolverChoice{Method::jacobi, Acceleration::none};
  });
  return static_cast<std::size_t>(plain - pairs_.begin());
}

double BeamStep::error(const State& state) const {
  return std::sqrt(squared_distance(state.displacement, exact_.displacement) /
                   squared_distance(exact_.displacement, predicted_));
}

double BeamStep::error_after(PairTrace& pair, int iterations) const {
  pair.solver->set_settings(settings_of(pair.pair, iterations));
  pair.solver->upload(start_);
  pair.solver->step();
  return error(pair.solver->download());
}

std::vector<std::string> BeamStep::notes() const {
  const Material& m = model_.materials.front();
  std::ostringstream beam, exact;
  beam << "beam of " << model_.tets.size() << " tets, E = " << m.young_modulus << " Pa, nu = " << m.poisson_ratio
       << ", density " << m.density << " kg/m^3; one step of 1/60 s from a smooth bend and twist at rest";
  exact << "rms_strain of the exact step: " << exact_strain_;
  return {
      beam.str(), exact.str(),
      "error: RMS |x - x_exact| over RMS |x_exact - x~|, x~ the prediction that the iterations start from",
      "chebyshev finds its spectral radius within this one step; in a simulation it keeps that of the steps before"};
}

Table BeamStep::traces() const {
  Table table;
  table.notes = notes();
  table.columns = {"method", "acceleration", "iteration", "rms_strain", "residual", "inverted_tets"};
  for (const PairTrace& p : pairs_)
    for (std::size_t i = 0; i < p.trace.size(); ++i) {
      const Diagnostics& d = p.trace[i];
      table.rows.push_back({name_of(p.pair.method), name_of(p.pair.acceleration), i, d.finite ? d.rms_strain : kUnknown,
                            d.finite ? d.residual : kUnknown, d.inverted});
    }
  return table;
}

void BeamStep::add_last(std::vector<Cell>& row, const PairTrace& pair) const {
  const Diagnostics& last = pair.trace.back();
  row.insert(row.end(),
             {last.finite ? last.rms_strain : kUnknown, pair.error, last.inverted, last.finite ? "yes" : "no"});
}

Chart BeamStep::chart(const std::string& title) const {
  Chart chart;
  chart.title = title + ", " + std::to_string(model_.tets.size()) + " tets";
  const double start = pairs_.front().trace.front().rms_strain;
  double smallest = exact_strain_, largest = exact_strain_;
  for (const PairTrace& p : pairs_) {
    Series series;
    series.name = label_of(p.pair) + (p.trace.back().finite ? "" : ", diverges");
    series.color = static_cast<int>(p.pair.method);
    series.dash = static_cast<int>(p.pair.acceleration);
    for (std::size_t i = 1; i < p.trace.size(); ++i) {
      const double strain = p.trace[i].finite ? p.trace[i].rms_strain : kUnknown;
      series.points.emplace_back(static_cast<double>(i), strain);
      smallest = std::fmin(smallest, strain);
      largest = std::fmax(largest, strain);
    }
    chart.series.push_back(std::move(series));
  }
  chart.x = {"iterations", true, Eigen::Vector2d(1, scene_.solver.iterations)};
  chart.y = {"Green strain, RMS of the Frobenius norm [-]", true,
             Eigen::Vector2d(0.7 * smallest, std::min(1.7 * start, 1.15 * largest))};
  chart.levels.push_back({"Exact step", exact_strain_});
  return chart;
}

}  // namespace fascia
