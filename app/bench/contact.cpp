#include "app/bench/contact.h"

#include <cmath>
#include <cstdio>

#include "app/bench/bench.h"
#include "app/bench/box.h"
#include "app/bench/timing.h"
#include "sim/output/sample.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

Tool tool_of(const std::string& name, const ToolShape& shape, std::vector<Instrument::Key> path) {
  Tool tool;
  tool.name = name;
  tool.shape = shape;
  tool.friction = 0.3;
  tool.path = std::move(path);
  return tool;
}

double longest_edge(const Model& model) {
  double longest = 0;
  for (const Tet& t : model.tets)
    for (std::size_t a = 0; a < 4; ++a)
      for (std::size_t b = 0; b < a; ++b)
        longest = std::max(longest, (model.rest_positions[t[a]] - model.rest_positions[t[b]]).norm());
  return longest;
}

// A slab over a share of the top, from the free end on, pressed in by 5 mm. Its height makes contact points of `level`.
Tool slab(const Model& model, double share, int level, bool near) {
  const double half_height = 2.2 * longest_edge(model) / (1 << level), top = near ? 0.245 : 0.75;
  return tool_of("slab", BoxShape{{0, 0, 0}, {0.5 * share, half_height, 0.2}},
                 {{0, {1 - 0.5 * share, top + half_height, 0.125}, {0, 0, 0}}});
}

SolverSettings with(int iterations) {
  SolverSettings settings;
  settings.iterations = iterations;
  settings.rest_speed = 0;
  return settings;
}

std::uint32_t points_of(GpuSolver& solver) {
  solver.request_diagnostics();
  std::uint32_t points = 0;
  for (const ToolLoad& load : solver.take_diagnostics(true)->tool_loads) points += load.points;
  return points;
}

void print(const Bench& bench, const Table& table) {
  std::string line;
  for (const std::string& column : table.columns) line += (line.empty() ? "" : "  ") + column;
  bench.say(line);
  for (const std::vector<Cell>& row : table.rows) {
    line.clear();
    for (const Cell& cell : row) line += (line.empty() ? "" : "  ") + cell.text();
    bench.say(line);
  }
}

void bench_cost(Bench& bench) {
  Table table;
  table.notes = {
      "a step of 10 iterations of a box that a slab presses on the ground, and of the same box without tools, in turn",
      "points: those that press; ms: medians, _low, _high: a tenth is below, above"};
  table.columns = {"tets",  "tool",   "points", "dispatches_per_step", "dispatches_without", "ms", "ms_without",
                   "ratio", "ms_low", "ms_high"};
  struct Case {
    const char* name;
    double share;
    int level;
    bool near;
  };
  const std::vector<Case> cases = {{"far away", 1, 0, false},
                                   {"small slab", 0.2, 0, true},
                                   {"slab", 1, 0, true},
                                   {"thin slab", 1, 1, true},
                                   {"thinner slab", 1, 2, true}};
  for (const std::size_t tets : bench.full_or_quick<std::vector<std::size_t>>({5'000, 20'000, 80'000}, {500}))
    for (const Case& c : cases) {
      const Model without = box_model(cells_of(tets));
      Model model = without;
      model.tools = {slab(model, c.share, c.level, c.near)};
      if (c.near) model.tools.push_back(tool_of("ground", PlaneShape{{0, 0, 0}, {0, 1, 0}}, {{}}));
      bench.say("contact: " + std::to_string(model.tets.size()) + " tets, " + c.name);
      GpuSolver touching(*bench.graphics.programs, model, with(10)), alone(*bench.graphics.programs, without, with(10));
      for (int step = 0; step < 20; ++step) touching.step();
      const State start = touching.download();
      std::vector<double> times, times_alone;
      for (int turn = 0; turn <= bench.full_or_quick(25, 3); ++turn)
        for (GpuSolver* solver : {&touching, &alone}) {
          bench.stop_if_interrupted();
          solver->upload(start);
          const double ms = milliseconds_of([&] { solver->step(); });
          if (turn > 0) (solver == &touching ? times : times_alone).push_back(ms);
        }
      const Spread ms = spread_of(times), ms_alone = spread_of(times_alone);
      table.rows.push_back({model.tets.size(), c.name, points_of(touching), touching.dispatches_per_step(),
                            alone.dispatches_per_step(), ms.median, ms_alone.median, ms.median / ms_alone.median,
                            ms.low, ms.high});
    }
  print(bench, table);
  bench.write("contact_cost", std::move(table));
}

// A cube of 20 cm and 20 kPa on the ground, into which a tool is pressed by up to 3 cm, sliding.
Model pressed_cube(const std::string& name, const ToolShape& shape, double reach, int cells) {
  Model model = box_model({cells, cells, cells});
  for (Vector3d& x : model.rest_positions) x = x.cwiseProduct(Vector3d(0.2, 0.8, 0.8));
  model.file_mesh.positions = model.rest_positions;
  model.materials[0].young_modulus = 2e4;
  model.fixed.clear();
  model.gravity = {0, -9.81, 0};
  model.tools = {
      tool_of("ground", PlaneShape{{0, 0, 0}, {0, 1, 0}}, {{}}),
      tool_of(name, shape, {{0, {0.1, 0.21 + reach, 0.1}, {0, 0, 0}}, {0.4, {0.11, 0.17 + reach, 0.1}, {0, 0, 0}}})};
  return model;
}

double distance(const State& a, const State& b) {
  double largest = 0;
  for (std::size_t v = 0; v < a.displacement.size(); ++v)
    largest = std::max(largest, (a.displacement[v] - b.displacement[v]).norm());
  return largest;
}

void bench_iterations(Bench& bench) {
  Table table;
  table.notes = {
      "a cube on the ground into which a tool is pressed: every step from the same state as the exact one",
      "error: largest distance to the exact step, root of the mean square over the steps, over that of the way"};
  table.columns = {"tool", "steps", "iterations_to_10_percent", "iterations_to_1_percent", "iterations_to_0.1_percent"};
  const std::vector<int> counts =
      bench.full_or_quick<std::vector<int>>({1, 2, 3, 4, 5, 6, 7, 8, 10, 12, 14, 17, 20, 25, 30, 40}, {5, 10, 20});
  for (const int iterations : counts) table.columns.push_back("error_" + std::to_string(iterations));
  const int cells = bench.full_or_quick(6, 3), steps = bench.full_or_quick(36, 4);
  struct Case {
    std::string name;
    ToolShape shape;
    double reach;  // [m] of the shape below its origin
  };
  const std::vector<Case> cases = {{"sphere", SphereShape{{0, 0, 0}, 0.06}, 0.06},
                                   {"capsule", CapsuleShape{{-0.2, 0, 0}, {0.2, 0, 0}, 0.05}, 0.05},
                                   {"box", BoxShape{{0, 0, 0}, {0.05, 0.03, 0.05}, 0.01}, 0.03},
                                   {"cylinder", CylinderShape{{0, 0, 0}, {0, 0.1, 0}, 0.06}, 0}};
  for (const Case& c : cases) {
    bench.say("contact: iterations with a " + c.name);
    const Model model = pressed_cube(c.name, c.shape, c.reach, cells);
    std::vector<std::unique_ptr<GpuSolver>> solvers;
    for (const int iterations : counts)
      solvers.push_back(std::make_unique<GpuSolver>(*bench.graphics.programs, model, with(iterations)));
    reference::NewtonSolver newton(model, with(10));
    std::vector<double> squares(counts.size(), 0);
    double ways = 0;
    State state = initial_state(model);
    for (int step = 0; step < steps; ++step) {
      bench.stop_if_interrupted();
      State exact = state;
      newton.step(exact);
      ways += std::pow(distance(exact, state), 2);
      for (std::size_t k = 0; k < counts.size(); ++k) {
        solvers[k]->upload(state);
        solvers[k]->step();
        squares[k] += std::pow(distance(solvers[k]->download(), exact), 2);
      }
      state = solvers.back()->download();
    }
    std::vector<double> errors;
    for (const double square : squares) errors.push_back(std::sqrt(square / ways));
    std::vector<Cell> row = {c.name, steps};
    for (const double limit : {0.1, 0.01, 0.001}) {
      std::size_t k = 0;
      while (k < errors.size() && errors[k] > limit) ++k;
      row.push_back(k < errors.size() ? Cell(counts[k]) : Cell("more"));
    }
    row.insert(row.end(), errors.begin(), errors.end());
    table.rows.push_back(std::move(row));
  }
  print(bench, table);
  bench.write("contact_iterations", std::move(table));
}

}  // namespace

void bench_contact(Bench& bench) {
  bench_cost(bench);
  bench_iterations(bench);
  bench_contact_probe(bench);
}

}  // namespace fascia
