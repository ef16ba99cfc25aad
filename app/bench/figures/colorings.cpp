// Measures the colors of Gauss-Seidel: the number that a mesh needs, their balance, and the time of an iteration with
// fewer colors and phantoms instead.
#include <algorithm>
#include <array>

#include "app/bench/bench.h"
#include "app/bench/box.h"
#include "app/bench/timing.h"

namespace fascia {
namespace {

constexpr std::array kColorsAsked{0, 16, 8, 4, 1};  // 0: as many as the mesh needs

SolverSettings settings_with(int colors, int iterations) {
  SolverSettings settings;
  settings.method = Method::gauss_seidel;
  settings.acceleration = Acceleration::none;
  settings.colors = colors;
  settings.iterations = iterations;
  return settings;
}

std::uint64_t dispatches_per_iteration(GpuSolver& solver, int colors) {
  const auto dispatches = [&](int iterations) {
    solver.set_settings(settings_with(colors, iterations));
    return solver.dispatches_per_step();
  };
  return dispatches(2) - dispatches(1);
}

// Rows of one mesh, and its series: phantoms as a line, the plain coloring as a point.
void bench_box(Bench& bench, const Eigen::Vector3i& cells, int index, Table& table, Chart& chart) {
  const Model model = box_model(cells);
  std::vector<std::unique_ptr<GpuSolver>> solvers;
  std::vector<GpuSolver*> timed;
  std::vector<std::uint64_t> dispatches;
  for (const int colors : kColorsAsked) {
    bench.stop_if_interrupted();
    solvers.push_back(std::make_unique<GpuSolver>(*bench.graphics.programs, model, settings_with(colors, 1)));
    timed.push_back(solvers.back().get());
    dispatches.push_back(dispatches_per_iteration(*timed.back(), colors));
    timed.back()->set_settings(settings_with(colors, bench.full_or_quick(20, 5)));
  }
  const std::vector<Spread> times = time_iterations(timed, initial_state(model), bench.full_or_quick(15, 3));

  const std::string tets = std::to_string(model.tets.size()) + " tets";
  Series phantoms, plain;
  phantoms.name = tets + ", phantoms";
  plain.name = tets + ", no phantoms";
  phantoms.color = plain.color = index;
  phantoms.marks = plain.marks = true;
  plain.line = false;
  for (std::size_t i = 0; i < kColorsAsked.size(); ++i) {
    const Coloring& coloring = *timed[i]->coloring();
    std::vector<std::uint32_t> sizes;
    for (std::size_t c = 0; c < coloring.color_count(); ++c) sizes.push_back(coloring.begin[c + 1] - coloring.begin[c]);
    const auto [smallest, largest] = std::minmax_element(sizes.begin(), sizes.end());
    table.rows.push_back({model.tets.size(), model.rest_positions.size(), kColorsAsked[i], sizes.size(), *smallest,
                          *largest, coloring.phantom_vertex.size(), dispatches[i], times[i].median, times[i].low,
                          times[i].high});
    (kColorsAsked[i] == 0 ? plain : phantoms)
        .points.emplace_back(static_cast<double>(sizes.size()),
                             1e6 * times[i].median / static_cast<double>(model.tets.size()));
  }
  chart.series.push_back(std::move(phantoms));
  chart.series.push_back(std::move(plain));
}

}  // namespace

void bench_colorings(Bench& bench) {
  const std::vector<Eigen::Vector3i> boxes = bench.full_or_quick<std::vector<Eigen::Vector3i>>(
      {{24, 6, 6}, {40, 9, 9}, {66, 16, 16}}, {{8, 2, 2}, {12, 4, 4}, {16, 6, 6}});
  Table table;
  table.notes = {
      "boxes of cells cut into 6 tets, one face held; gauss_seidel, colors_asked 0: as many as the mesh needs",
      "smallest_color, largest_color: tets in it; dispatches: of one iteration, 1 where its colors are fused; ms: "
      "medians over steps"};
  table.columns = {"tets",
                   "vertices",
                   "colors_asked",
                   "colors",
                   "smallest_color",
                   "largest_color",
                   "phantoms",
                   "dispatches",
                   "ms_per_iteration",
                   "ms_per_iteration_low",
                   "ms_per_iteration_high"};
  Chart chart;
  chart.title = "Gauss-Seidel: colors against time";
  chart.x = {"colors", false, {}};
  chart.y = {"time of an iteration [ns per tet], " + gl::device().renderer, false, {}};
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    bench.say("colorings: " + std::to_string(6 * boxes[i].prod()) + " tets");
    bench_box(bench, boxes[i], static_cast<int>(i), table, chart);
  }
  bench.write("colorings", std::move(table));
  bench.draw("colorings", chart);
}

}  // namespace fascia
