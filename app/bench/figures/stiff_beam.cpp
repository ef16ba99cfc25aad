// Figure 2 of the I3D 2019 paper: a stiff beam after half a second under its weight, by averaged Jacobi with each
// acceleration, and by the exact solution of the same steps.
#include <cmath>

#include "app/bench/beam.h"
#include "app/bench/bench.h"
#include "app/bench/figures/picture_grid.h"
#include "app/ui/units.h"
#include "render/target/framebuffer.h"

namespace fascia {
namespace {

constexpr double kYoungModulus = 1e9;  // [Pa]

struct Candidate {
  std::string method, acceleration;  // as in scene files
  std::vector<std::string> caption;  // for display
  std::unique_ptr<Session> session;
};

Scene hanging_beam(const Bench& bench, const SolverChoice& pair) {
  SolverSettings settings;
  settings.method = pair.method;
  settings.acceleration = pair.acceleration;
  settings.iterations = bench.full_or_quick(40, 10);
  Scene scene = beam_scene(bench, kYoungModulus, settings);
  scene.camera = CameraSettings{{1.7, 0.3, 4.1}, {0.48, -0.47, 0.125}, {0, 1, 0}, 23};
  scene.display.color = ColorBy::strain;
  scene.display.range = Eigen::Vector2d(0, 0.4);
  return scene;
}

std::vector<Candidate> candidates_of(Bench& bench) {
  std::vector<Candidate> candidates;
  for (const SolverChoice& pair : i3d2019_choices())
    if (pair.method == Method::jacobi)
      candidates.push_back({name_of(pair.method),
                            name_of(pair.acceleration),
                            {label_of(pair.method), std::string("acceleration: ") + label_of(pair.acceleration)},
                            std::make_unique<Session>(bench.graphics, hanging_beam(bench, pair), false)});
  candidates.push_back(
      {"exact",
       "none",
       {"Exact solver", ""},
       std::make_unique<Session>(bench.graphics, hanging_beam(bench, i3d2019_choices().front()), true)});
  return candidates;
}

Image picture_of(const Bench& bench, Session& session) {
  session.look.ground = false;  // soft beams fall through it
  session.look.center = {0.5, -0.5, 0.125};
  session.look.radius = 1.3;
  Framebuffer framebuffer(bench.options.width / 3, bench.options.height * 2 / 3, 4);
  session.draw(framebuffer);
  return framebuffer.read();
}

double tip_deflection(const Model& model, const State& state) {
  const std::vector<std::uint32_t> tip = beam_tip(model);
  double sum = 0;
  for (const std::uint32_t v : tip) sum -= state.displacement[v].y();
  return sum / static_cast<double>(tip.size());
}

// RMS of the difference from the exact displacement, relative to the RMS of that displacement.
double relative_error(const State& state, const State& exact) {
  const std::vector<Eigen::Vector3d> rest(exact.displacement.size(), Eigen::Vector3d::Zero());
  return std::sqrt(squared_distance(state.displacement, exact.displacement) /
                   squared_distance(exact.displacement, rest));
}

}  // namespace

void bench_stiff_beam(Bench& bench) {
  const int steps = bench.full_or_quick(30, 6);
  std::vector<Candidate> candidates = candidates_of(bench);
  const Simulation& exact = candidates.back().session->simulation;
  const SolverSettings& settings = exact.scene.solver;
  bench.say("figure 2: stiff beam, " + std::to_string(exact.model.tets.size()) + " tets, " + std::to_string(steps) +
            " steps of " + std::to_string(settings.iterations) + " iterations, and exactly");
  for (int step = 0; step < steps; ++step)
    for (Candidate& c : candidates) {
      bench.stop_if_interrupted();
      c.session->simulation.step();
    }

  Table table;
  table.notes = {
      "beam of " + std::to_string(exact.model.tets.size()) + " tets, E = 1e9 Pa, from rest under gravity, " +
          std::to_string(steps) + " steps of 1/60 s with " + std::to_string(settings.iterations) + " iterations each",
      "relative_error: RMS of the difference to the exact solver's displacement over the RMS of that displacement"};
  table.columns = {"method",        "acceleration", "tip_deflection_m", "rms_strain", "relative_error",
                   "inverted_tets", "finite"};
  PictureGrid grid;
  grid.title = "Stiff beam (E = 1 GPa, " + std::to_string(exact.model.tets.size()) + " tets) after " +
               std::to_string(steps) + " steps of 1/60 s, " + std::to_string(settings.iterations) +
               " iterations a step";
  grid.scale_label = label_of(candidates.back().session->display().color);
  grid.range = *exact.scene.display.range;
  grid.columns = 4;
  const State exact_state = exact.state();
  for (Candidate& c : candidates) {
    const State state = c.session->simulation.state();
    const reference::Measures measures = reference::measure(exact.model, state);
    const double tip = tip_deflection(exact.model, state);
    table.rows.push_back({c.method, c.acceleration, tip, measures.rms_strain, relative_error(state, exact_state),
                          measures.inverted, is_finite(state) ? "yes" : "no"});
    Image picture = picture_of(bench, *c.session);
    bench.write("fig2_" + c.method + (c.method == "exact" ? "" : "_" + c.acceleration), picture, *c.session, steps);
    c.caption.push_back("tip " + engineering(tip, "m") + " lower");
    grid.panels.push_back({std::move(picture), c.caption});
  }
  bench.write("fig2", std::move(table));
  if (bench.has_gnuplot) write_grid(bench.folder / "fig2.png", grid);
}

}  // namespace fascia
