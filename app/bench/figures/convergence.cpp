// Figures 3 and 4 of the I3D 2019 paper: the decrease of the strain of a bent beam to that of the exact step, by
// iterations and by time, and its final value, for every solver choice.
#include <algorithm>
#include <optional>

#include "app/bench/bench.h"
#include "app/bench/figures/beam_step.h"
#include "app/bench/timing.h"

namespace fascia {
namespace {

int traced_iterations(const Bench& bench) { return bench.full_or_quick(1500, 60); }

/// Times of a step of many iterations for every choice.
std::vector<Spread> iteration_times(const Bench& bench, BeamStep& step) {
  std::vector<GpuSolver*> solvers;
  for (PairTrace& p : step.pairs()) {
    SolverSettings settings = p.solver->settings();
    settings.iterations = bench.full_or_quick(50, 10);
    p.solver->set_settings(settings);
    solvers.push_back(p.solver.get());
  }
  return time_iterations(solvers, step.start(), bench.full_or_quick(15, 3));
}

/// A strain to reach, and the first iteration of each choice that reaches it with every tet upright.
struct Target {
  std::string name;
  double strain;
  std::vector<std::optional<int>> iterations;  // [pairs]

  Target(const std::string& n, double s, BeamStep& step) : name(n), strain(s) {
    for (const PairTrace& p : step.pairs()) iterations.push_back(first_at(p.trace));
  }

 private:
  std::optional<int> first_at(const std::vector<Diagnostics>& trace) const {
    for (std::size_t i = 1; i < trace.size(); ++i)
      if (trace[i].finite && trace[i].inverted == 0 && trace[i].rms_strain <= strain) return static_cast<int>(i);
    return std::nullopt;
  }
};

// Iterations, their milliseconds, the speedup over the plain method, and the error at that point; empty if not reached.
void add_target(std::vector<Cell>& row, const Target& target, std::size_t p, BeamStep& step,
                const std::vector<Spread>& times) {
  if (!target.iterations[p]) {
    row.insert(row.end(), 4, Cell());
    return;
  }
  const auto ms = [&](std::size_t pair) { return *target.iterations[pair] * times[pair].median; };
  const std::size_t plain = step.plain();
  row.insert(row.end(), {*target.iterations[p], ms(p)});
  row.emplace_back(target.iterations[plain] ? Cell(ms(plain) / ms(p)) : Cell());
  row.emplace_back(step.error_after(step.pairs()[p], *target.iterations[p]));
}

Table targets_table(BeamStep& step, const std::vector<Spread>& times, int plain_iterations) {
  const std::vector<Target> targets{
      {"poster", step.pairs()[step.plain()].trace[static_cast<std::size_t>(plain_iterations)].rms_strain, step},
      {"exact", 1.01 * step.exact_strain(), step}};
  Table table;
  table.notes = step.notes();
  table.notes.push_back("target poster: the strain of plain averaged Jacobi after " + std::to_string(plain_iterations) +
                        " iterations; target exact: 1.01 times the strain of the exact step");
  table.notes.emplace_back(
      "reached: the first time at or below the target with no tet inverted; an empty cell: not reached in " +
      std::to_string(step.pairs().front().trace.size() - 1) + " iterations");
  table.notes.emplace_back(
      "ms: iterations times the median of ms_per_iteration; times_faster: against plain averaged Jacobi");
  table.columns = {"method", "acceleration", "ms_per_iteration", "ms_per_iteration_low", "ms_per_iteration_high"};
  for (const Target& target : targets)
    for (const char* column : {"strain", "iterations", "ms", "times_faster", "error"})
      table.columns.push_back(target.name + "_target_" + column);
  table.columns.insert(table.columns.end(), {"last_rms_strain", "last_error", "last_inverted_tets", "finite"});
  for (std::size_t p = 0; p < step.pairs().size(); ++p) {
    const PairTrace& pair = step.pairs()[p];
    std::vector<Cell> row{name_of(pair.pair.method), name_of(pair.pair.acceleration), times[p].median, times[p].low,
                          times[p].high};
    for (const Target& target : targets) {
      row.emplace_back(target.strain);
      add_target(row, target, p, step, times);
    }
    step.add_last(row, pair);
    table.rows.push_back(std::move(row));
  }
  return table;
}

void figure_3(Bench& bench) {
  const int iterations = traced_iterations(bench);
  bench.say("figure 3: strain against iterations, E = 1e9 Pa, " + std::to_string(i3d2019_choices().size()) +
            " pairs, " + std::to_string(iterations) + " iterations");
  BeamStep step(bench, 1e9, iterations);
  bench.say("figure 3: strain against time");
  const std::vector<Spread> times = iteration_times(bench, step);

  Table traces = step.traces();
  traces.columns.emplace_back("ms");
  std::size_t row = 0;
  for (std::size_t p = 0; p < step.pairs().size(); ++p)
    for (std::size_t i = 0; i < step.pairs()[p].trace.size(); ++i)
      traces.rows[row++].emplace_back(static_cast<double>(i) * times[p].median);
  bench.write("fig3", std::move(traces));
  bench.write("fig3_target", targets_table(step, times, iterations / 3));

  Chart chart = step.chart("Strain of a stiff beam (E = 1 GPa) in one step");
  bench.draw("fig3_iterations", chart);
  chart.x.label = "time in the step [ms], " + std::string(gl::device().renderer);
  const auto [fastest, slowest] = std::minmax_element(
      times.begin(), times.end(), [](const Spread& a, const Spread& b) { return a.median < b.median; });
  *chart.x.range = {fastest->median, iterations * slowest->median};
  for (std::size_t p = 0; p < step.pairs().size(); ++p)
    for (Eigen::Vector2d& point : chart.series[p].points) point.x() *= times[p].median;
  bench.draw("fig3_time", chart);
}

void figure_4(Bench& bench) {
  const int iterations = traced_iterations(bench);
  bench.say("figure 4: the same at E = 1e6 Pa");
  BeamStep step(bench, 1e6, iterations);
  bench.write("fig4", step.traces());

  Table table;
  table.notes = step.notes();
  table.columns = {"method",     "acceleration",       "iterations", "last_rms_strain",
                   "last_error", "last_inverted_tets", "finite"};
  for (const PairTrace& p : step.pairs()) {
    std::vector<Cell> row{name_of(p.pair.method), name_of(p.pair.acceleration), iterations};
    step.add_last(row, p);
    table.rows.push_back(std::move(row));
  }
  table.rows.push_back({"exact", "none", "", step.exact_strain(), 0, 0, "yes"});
  bench.write("fig4_last", std::move(table));

  Chart chart = step.chart("Strain of a softer beam (E = 1 MPa) in one step");
  chart.y.logarithmic = false;
  chart.y.range->x() = 0;
  bench.draw("fig4", chart);
}

}  // namespace

void bench_convergence(Bench& bench) {
  figure_3(bench);
  figure_4(bench);
}

}  // namespace fascia
