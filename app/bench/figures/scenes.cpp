// Figure 1 of the I3D 2019 paper: the two scenes, drawn, and the cost of a frame with their own settings and with those
// of the paper.
#include "app/bench/bench.h"
#include "app/bench/timing.h"
#include "app/system/paths.h"
#include "render/target/framebuffer.h"

namespace fascia {
namespace {

struct Variant {
  std::string name;
  std::unique_ptr<Session> session;
  std::vector<double> solve_ms, draw_ms, frame_ms;  // [frames]
};

SolverSettings poster_settings(Acceleration acceleration) {
  SolverSettings settings;
  settings.method = Method::jacobi;
  settings.acceleration = acceleration;
  settings.iterations = 20;
  settings.substeps = 1;
  return settings;
}

std::vector<Variant> variants_of(Bench& bench, const std::string& name) {
  const Scene scene = open_scene(default_scene(bench.graphics.data_dir).parent_path() / (name + ".json"));
  std::vector<Variant> variants;
  const auto add = [&](const std::string& settings_name, const SolverSettings& settings) {
    Scene with_settings = scene;
    with_settings.solver = settings;
    for (Body& body : with_settings.bodies)  // the method's own law, where it does not carry the scene's
      if (!carries(settings.method, body.material.model)) body.material.model = Material().model;
    variants.push_back(
        {settings_name, std::make_unique<Session>(bench.graphics, std::move(with_settings), false), {}, {}, {}});
  };
  add("scene", scene.solver);
  add("poster", poster_settings(Acceleration::none));
  add("poster_anderson", poster_settings(Acceleration::anderson_positions));
  return variants;
}

void add_spread(std::vector<Cell>& row, const std::vector<double>& values) {
  const Spread spread = spread_of(values);
  row.insert(row.end(), {spread.median, spread.low, spread.high});
}

void bench_scene(Bench& bench, const std::string& name, int frames, Table& table) {
  std::vector<Variant> variants = variants_of(bench, name);
  const int samples = gl::device().software ? 1 : 4;  // the number in the window
  Framebuffer framebuffer(bench.options.width, bench.options.height, samples);
  for (Variant& v : variants) {  // kernels are compiled at their first run
    v.session->simulation.step();
    v.session->draw(framebuffer);
    v.session->simulation.reset();
  }
  for (int frame = 0; frame < frames; ++frame)
    for (Variant& v : variants) {
      bench.stop_if_interrupted();
      v.solve_ms.push_back(milliseconds_of([&] { v.session->simulation.step(); }));
      v.draw_ms.push_back(milliseconds_of([&] {
        v.session->follow_range();
        v.session->draw(framebuffer);
      }));
      v.frame_ms.push_back(v.solve_ms.back() + v.draw_ms.back());
    }

  for (const Variant& v : variants) {
    const Model& model = v.session->simulation.model;
    const SolverSettings& s = v.session->simulation.scene.solver;
    std::vector<Cell> row{name,       model.tets.size(), model.rest_positions.size(),
                          v.name,     name_of(s.method), name_of(s.acceleration),
                          s.substeps, s.iterations,      samples,
                          frames};
    add_spread(row, v.solve_ms);
    add_spread(row, v.draw_ms);
    add_spread(row, v.frame_ms);
    row.push_back(1000 / spread_of(v.frame_ms).median);
    table.rows.push_back(std::move(row));
  }
  Framebuffer smooth(bench.options.width, bench.options.height, 4);
  variants.front().session->settle_range();
  variants.front().session->draw(smooth);
  bench.write("fig1_" + name, smooth.read(), *variants.front().session, frames);
}

}  // namespace

void bench_scenes(Bench& bench) {
  const int frames = bench.full_or_quick(60, 3);  // full: a second
  bench.say("figure 1: two scenes, " + std::to_string(frames) + " frames each with three settings");
  Table table;
  table.notes = {
      "a frame is one step of the scene and one picture of " + std::to_string(bench.options.width) + "x" +
          std::to_string(bench.options.height) + " pixels, each waited for: frame_ms = solve_ms + draw_ms",
      "the settings take turns; medians over the frames; _low and _high: a tenth of the frames is below, above"};
  table.columns = {"scene",        "tets",         "vertices",      "settings",          "method",
                   "acceleration", "substeps",     "iterations",    "samples_per_pixel", "frames",
                   "solve_ms",     "solve_ms_low", "solve_ms_high", "draw_ms",           "draw_ms_low",
                   "draw_ms_high", "frame_ms",     "frame_ms_low",  "frame_ms_high",     "frames_per_second"};
  for (const char* name : {"liver", "ligament"}) bench_scene(bench, name, frames, table);
  bench.write("fig1", std::move(table));
}

}  // namespace fascia
