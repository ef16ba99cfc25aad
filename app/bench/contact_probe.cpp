// The motion under a probe that presses and slides, against hard contact: steps whose multipliers are iterated until
// nothing is inside the probe.
#include <algorithm>
#include <cmath>
#include <memory>

#include "app/bench/bench.h"
#include "app/bench/box.h"
#include "app/bench/contact.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

// A ball of 10 cm is pressed 3 cm into a beam without weight that is held at both ends, at 0.3 m/s, waits, slides by
// 10 cm, and waits.
Model probed_beam(bool quick) {
  Model model = box_model(quick ? Eigen::Vector3i(8, 2, 2) : Eigen::Vector3i(16, 4, 4));
  model.materials[0].young_modulus = 1e5;
  model.gravity.setZero();
  for (std::uint32_t v = 0; v < model.rest_positions.size(); ++v)
    if (model.rest_positions[v].x() > 1 - 1e-9) model.fixed.push_back(v);
  Tool probe;
  probe.name = "probe";
  probe.shape = SphereShape{{0, 0, 0}, 0.1};
  probe.friction = 0.3;
  probe.path = {{0, {0.5, 0.352, 0.125}, {0, 0, 0}},
                {0.11, {0.5, 0.319, 0.125}, {0, 0, 0}},
                {0.3, {0.5, 0.319, 0.125}, {0, 0, 0}},
                {0.63, {0.6, 0.319, 0.125}, {0, 0, 0}},
                {0.9, {0.6, 0.319, 0.125}, {0, 0, 0}}};
  model.tools = {probe};
  return model;
}

SolverSettings of_iterations(int iterations) {
  SolverSettings settings;
  settings.iterations = iterations;
  settings.rest_speed = 0;
  return settings;
}

double largest_change(const ContactMemory& a, const ContactMemory& b) {
  double largest = 0;
  for (std::size_t row = 0; row < a.size(); ++row)
    largest = std::max(largest, std::abs(a[row].normal - (row < b.size() ? b[row].normal : 0)));
  return largest;
}

// A step whose normal forces are those of hard contact: repeated from the same start with the forces that it left.
State hard_step(reference::NewtonSolver& newton, const State& start) {
  constexpr int kMost = 60;
  constexpr double kSame = 1e-4;  // [N]
  State from = start, to = start;
  for (int k = 0; k < kMost; ++k) {
    to = from;
    newton.step(to);
    const double change = largest_change(to.contact, from.contact);
    from.contact.resize(to.contact.size());
    for (std::size_t row = 0; row < to.contact.size(); ++row) from.contact[row].normal = to.contact[row].normal;
    if (change < kSame) break;
  }
  return to;
}

double squares(const State& a, const State& b) {
  double sum = 0;
  for (std::size_t v = 0; v < a.displacement.size(); ++v) sum += (a.displacement[v] - b.displacement[v]).squaredNorm();
  return sum;
}

}  // namespace

void bench_contact_probe(Bench& bench) {
  Table table;
  table.notes = {"a ball that presses a beam of 1 m and slides: the motion, against hard contact in the same steps",
                 "error: RMS distance over all steps and vertices, over the RMS displacement",
                 "worst_depth, last_depth: the deepest point in the probe [m], over all steps, after the last one"};
  table.columns = {"solver", "steps", "error", "worst_depth_m", "last_depth_m"};
  const Model model = probed_beam(bench.full_or_quick(false, true));
  const int steps = bench.full_or_quick(54, 12);
  bench.say("contact: hard contact under a probe");
  std::vector<State> exact{initial_state(model)};
  reference::NewtonSolver hard(model, of_iterations(10));
  double scale = 0;
  for (int i = 0; i < steps; ++i) {
    bench.stop_if_interrupted();
    exact.push_back(hard_step(hard, exact.back()));
    scale += squares(exact.back(), exact.front());
  }
  const auto add = [&](const std::string& name, const std::function<std::pair<State, double>()>& step) {
    bench.say("contact: a probe with " + name);
    double error = 0, worst = 0, depth = 0;
    for (int i = 0; i < steps; ++i) {
      bench.stop_if_interrupted();
      const auto [state, deepest] = step();
      error += squares(state, exact[static_cast<std::size_t>(i) + 1]);
      worst = std::max(worst, depth = deepest);
    }
    table.rows.push_back({name, steps, std::sqrt(error / scale), worst, depth});
  };
  reference::NewtonSolver newton(model, of_iterations(10));
  State state = initial_state(model);
  add("exact steps", [&] {
    newton.step(state);
    return std::pair(state, newton.tool_loads()[0].deepest);
  });
  for (const int iterations : {5, 10, 20}) {
    GpuSolver solver(*bench.graphics.programs, model, of_iterations(iterations));
    add(std::to_string(iterations) + " iterations", [&] {
      solver.step();
      solver.request_diagnostics();
      return std::pair(solver.download(), solver.take_diagnostics(true)->tool_loads[0].deepest);
    });
  }
  for (const std::vector<Cell>& row : table.rows) {
    std::string line;
    for (const Cell& cell : row) line += (line.empty() ? "" : "  ") + cell.text();
    bench.say(line);
  }
  bench.write("contact_probe", std::move(table));
}

}  // namespace fascia
