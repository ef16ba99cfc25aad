#include "app/bench/accuracy/continuum.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "app/bench/accuracy/summary.h"
#include "app/bench/timing.h"
#include "app/ui/units.h"
#include "app/verify/solids.h"
#include "base/file.h"
#include "base/text.h"
#include "sim/accuracy/relative_distance.h"
#include "sim/mesh/mesh_generate.h"
#include "sim/simulation/simulation.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

constexpr int kSteps = 60;      // of 1/60 s
constexpr int kWatchEvery = 6;  // steps: ten times in a second
constexpr int kTruthIterations = 20;

Model released_beam(int cells, double nu, ElementOrder elements) {
  Model model = solid(make_box(cells, cells / 4, cells / 4, {0.4, 0.1, 0.1}),
                      material_of(MaterialModel::signed_st_venant_kirchhoff, 2.5e5, nu), elements,
                      {BoxSelection{{-1e-6, -1, -1}, {1e-6, 1, 1}}});
  model.gravity = {0, -9.81, 0};
  return model;
}

/// The vertices that all meshes share: the corners of sections at every quarter of the length.
std::vector<std::uint32_t> watched(const Model& model) {
  const auto on_grid = [](double x) { return std::abs(x / 0.1 - std::round(x / 0.1)) < 1e-9; };
  std::vector<Vector3d> places;
  for (int i = 1; i <= 4; ++i)
    for (int k = 0; k < 4; ++k) places.emplace_back(0.1 * i, 0.1 * (k / 2), 0.1 * (k % 2));
  std::vector<std::uint32_t> found;
  for (const Vector3d& place : places)
    for (std::uint32_t v = 0; v < model.rest_positions.size(); ++v)
      if (const Vector3d& x = model.rest_positions[v];
          on_grid(x.x()) && on_grid(x.y()) && on_grid(x.z()) && (x - place).norm() < 1e-9)
        found.push_back(v);
  return found;
}

std::string tets_of(int cells) { return std::to_string(6 * cells * (cells / 4) * (cells / 4)); }

struct Motion60 {
  std::vector<Vector3d> displacements;  // of the watched vertices, at all times
  double ms = 0;                        // of a step, median
};

Motion60 move(const Bench& bench, const Model& model, const ContinuumChoice& choice, int substeps) {
  Scene scene;
  scene.solver.integrator = choice.integrator;
  scene.solver.iterations = choice.iterations;
  scene.solver.substeps = substeps;
  Simulation simulation(scene, model, bench.graphics.programs.get(), false);
  simulation.gpu()->finish_background();
  const std::vector<std::uint32_t> vertices = watched(model);
  Motion60 motion;
  std::vector<double> ms;
  for (int step = 1; step <= kSteps; ++step) {
    bench.stop_if_interrupted();
    ms.push_back(milliseconds_of([&] { simulation.step(); }));
    if (step % kWatchEvery != 0) continue;
    const State state = simulation.state();
    for (const std::uint32_t v : vertices) motion.displacements.push_back(state.displacement[v]);
  }
  motion.ms = spread_of(ms).median;
  return motion;
}

std::string name_of_kind(const ContinuumChoice& choice) {
  return std::string(name_of(choice.elements)) + ", " + name_of(choice.integrator);
}

std::vector<std::size_t> frontier_of(const std::vector<ContinuumPoint>& points) {
  std::vector<Eigen::Vector2d> places;
  for (const ContinuumPoint& point : points) places.emplace_back(point.ms, point.error);
  return pareto_frontier(places);
}

void draw(const Bench& bench, double nu, const std::vector<ContinuumPoint>& points) {
  Chart chart{"Released beam against the continuum, nu = " + number(nu),
              {"time of a step [ms], " + gl::device().renderer, true, {}},
              {"error of the motion of the first second, RMS [-]", true, {}},
              {},
              {}};
  Series frontier{"Pareto frontier", {}, 6};
  for (const std::size_t k : frontier_of(points)) frontier.points.emplace_back(points[k].ms, points[k].error);
  chart.series.push_back(std::move(frontier));
  for (const ContinuumPoint& point : points) {
    const std::string name = name_of_kind(point.choice);
    auto series =
        std::find_if(chart.series.begin(), chart.series.end(), [&](const Series& s) { return s.name == name; });
    if (series == chart.series.end()) {
      chart.series.push_back({name, {}, static_cast<int>(chart.series.size()) - 1, 0, false, true});
      series = chart.series.end() - 1;
    }
    series->points.emplace_back(point.ms, point.error);
  }
  std::string file = "continuum_nu" + engineering(nu, "", 7);
  std::erase(file, ' ');
  bench.draw(file, chart);
}

void write_frontier(std::ostream& out, double nu, const std::vector<ContinuumPoint>& points) {
  out << "\n## Released beam, nu = " << number(nu)
      << ": what no other choice beats\n\n| ms per step | error | elements, integrator | vertices | tets | "
         "iterations |\n|--:|--:|---|--:|--:|--:|\n";
  for (const std::size_t k : frontier_of(points)) {
    const ContinuumPoint& point = points[k];
    out << "| " << engineering(point.ms, "") << " | " << engineering(100 * point.error, "") << " % | "
        << name_of_kind(point.choice) << " | " << point.vertices << " | " << point.tets << " | "
        << point.choice.iterations << " |\n";
  }
}

// The tip of the hanging beam of fascia verify, which has the source of these numbers.
void bench_static_tips(const Bench& bench, const ContinuumGrid& grid) {
  struct Truth {
    double nu, tip;  // [m]
  };
  Table table{
      {"static tip of a beam of 1 m x 0.25 m x 0.25 m, E = 1e6 Pa, under its weight; error: against the continuum, "
       "which is known to 0.11, 0.19 and 0.23 %"},
      {"elements", "vertices", "tets", "poisson_ratio", "tip_m", "error"},
      {}};
  for (const auto& [nu, tip] : {Truth{0.3, -0.237290}, Truth{0.45, -0.232667}, Truth{0.49, -0.230663}})
    for (const ElementOrder elements : kElementOrders)
      for (const int cells : elements == ElementOrder::linear ? grid.linear_cells : grid.quadratic_cells) {
        bench.stop_if_interrupted();
        Scene scene;
        scene.solver.tolerance = 1e-5;
        const Model model = hanging_beam(cells, nu, elements);
        Simulation simulation(scene, model, bench.graphics.programs.get(), false);
        if (!simulation.solve_static().converged) continue;
        const double found = displacement_at(model, simulation.state(), {1, 0.125, 0.125}).y();
        table.rows.push_back(
            {name_of(elements), model.rest_positions.size(), model.tets.size(), nu, found, found / tip - 1});
        bench.say(count_of(model) + ", nu = " + number(nu) + ": static tip " + number(100 * (found / tip - 1)) +
                  " % off");
        bench.write("continuum_static", table);
      }
}

}  // namespace

ContinuumGrid continuum_grid(bool quick) {
  if (quick) return {{8, 16}, {4, 8}, {3, 10}, {0.3}, 16, 4};
  return {{16, 24, 36, 48, 64, 116}, {8, 12, 16, 20, 28}, {3, 5, 10, 20}, {0.3, 0.45, 0.49}, 32, 8};
}

std::vector<ContinuumChoice> ContinuumGrid::choices() const {
  std::vector<ContinuumChoice> all;
  for (const ElementOrder elements : kElementOrders)
    for (const int cells : elements == ElementOrder::linear ? linear_cells : quadratic_cells)
      for (const Integrator integrator : {Integrator::implicit_euler, Integrator::bdf2, Integrator::sdirk2})
        for (const int count : iterations) all.push_back({elements, cells, integrator, count});
  return all;
}

std::vector<ContinuumPoint> bench_continuum(Bench& bench, const ContinuumGrid& grid) {
  const std::vector<std::string> notes{
      "beam of 0.4 m x 0.1 m x 0.1 m, held at one end and let go at rest; E = 2.5e5 Pa, density 1000 kg/m^3, steps of "
      "1/60 s",
      "error: RMS over 16 vertices and ten times of the first second, over RMS displacement, against " +
          tets_of(grid.truth_cells) + " quadratic tets with BDF2 and " + std::to_string(grid.truth_substeps) +
          " substeps of " + std::to_string(kTruthIterations) + " iterations",
      "ms_median: wall time of a step"};
  Table table{
      notes, {"elements", "vertices", "tets", "poisson_ratio", "integrator", "iterations", "error", "ms_median"}, {}};
  std::ostringstream summary;
  summary << "# Accuracy against the continuum\n\n";
  for (const std::string& note : bench.notes()) summary << "- " << note << '\n';
  for (const std::string& note : notes) summary << "- " << note << '\n';
  std::vector<ContinuumPoint> all;
  const int coarser_cells = grid.truth_cells / 2;
  for (const double nu : grid.poisson_ratios) {
    const ContinuumChoice best{ElementOrder::quadratic, grid.truth_cells, Integrator::bdf2, kTruthIterations};
    const Motion60 truth = move(bench, released_beam(best.cells, nu, best.elements), best, grid.truth_substeps),
                   coarser =
                       move(bench, released_beam(coarser_cells, nu, best.elements), best, grid.truth_substeps / 2);
    table.notes.push_back(
        "nu = " + number(nu) + ": " + tets_of(coarser_cells) + " quadratic tets with half the substeps are " +
        number(100 * relative_distance(coarser.displacements, truth.displacements)) + " % off that truth");
    summary << "- " << table.notes.back() << '\n';
    std::vector<ContinuumPoint> points;
    for (const ContinuumChoice& choice : grid.choices()) {
      const Model model = released_beam(choice.cells, nu, choice.elements);
      const Motion60 motion = move(bench, model, choice, 1);
      const double error = relative_distance(motion.displacements, truth.displacements);
      points.push_back({choice, nu, model.rest_positions.size(), model.tets.size(), motion.ms,
                        std::isfinite(error) ? error : std::numeric_limits<double>::quiet_NaN()});
      table.rows.push_back({name_of(choice.elements), model.rest_positions.size(), model.tets.size(), nu,
                            name_of(choice.integrator), choice.iterations, points.back().error, motion.ms});
      bench.say("nu = " + number(nu) + ", " + count_of(model) + ", " + name_of(choice.integrator) + ", " +
                std::to_string(choice.iterations) + " iterations: " + number(100 * error) + " %, " + number(motion.ms) +
                " ms");
    }
    bench.write("continuum", table);
    write_frontier(summary, nu, points);
    draw(bench, nu, points);
    all.insert(all.end(), points.begin(), points.end());
  }
  bench_static_tips(bench, grid);
  write_file(bench.folder / "continuum.md", summary.str());
  return all;
}

}  // namespace fascia
