#include "app/bench/static_times.h"

#include "app/bench/box.h"
#include "app/bench/timing.h"
#include "sim/simulation/static_equilibrium.h"

namespace fascia {

void bench_static(Bench& bench) {
  Table table;
  table.columns = {"tets",       "vertices",          "tolerance",         "solve_ms",
                   "iterations", "newton_iterations", "relative_residual", "converged"};
  const std::vector<std::size_t> sizes =
      bench.full_or_quick<std::vector<std::size_t>>({5'000, 20'000, 100'000, 300'000, 1'000'000}, {500, 5'000});
  for (const std::size_t size : sizes) {
    bench.stop_if_interrupted();
    Model model = box_model(cells_of(size));
    const std::size_t tets = model.tets.size(), vertices = model.rest_positions.size();
    Scene scene;
    scene.solver.tolerance = 1e-5;
    Simulation simulation(std::move(scene), std::move(model), bench.graphics.programs.get(), false);
    simulation.gpu()->finish_background();
    StaticReport report;
    const double ms = milliseconds_of([&] { report = simulation.solve_static(static_news(bench.options.quiet)); });
    table.rows.push_back({tets, vertices, simulation.scene.solver.tolerance, ms, report.iterations,
                          report.newton_iterations, report.relative_residual, report.converged ? "yes" : "no"});
    bench.write("static", table);
    bench.say(std::to_string(tets) + " tets: " + std::to_string(ms / 1000) + " s, " + describe(report));
  }
}

}  // namespace fascia
