// fascia render: the same scene, headless: a PNG at the end, a video on the way.
#include <cmath>
#include <iostream>

#include "app/breakdown.h"
#include "app/commands.h"
#include "app/graphics.h"
#include "app/interrupt.h"
#include "app/overlay.h"
#include "app/recorder.h"
#include "app/session.h"
#include "sim/error.h"

namespace fascia {
namespace {

// Everything that one picture needs: the scene, then panels and color bar over the resolved frame.
void draw_frame(Session& session, Overlay& overlay, Framebuffer& framebuffer, bool panels) {
  require_sound(session.simulation);
  GpuSolver& solver = *session.simulation.gpu();
  solver.request_diagnostics();
  const std::optional<Diagnostics> diagnostics = solver.take_diagnostics(true);
  if (diagnostics) session.follow_range(*diagnostics);
  if (session.display().color == ColorBy::error) session.measure_error();
  session.draw(framebuffer);
  if (panels || session.look.heat_map) overlay.draw_headless(session, framebuffer, panels, diagnostics);
}

}  // namespace

int command_render(const RenderOptions& options) {
  if (options.out.empty() && options.video.empty())
    throw Error("fascia render", "no output named", "expected --out FILE.png, --video FILE.mp4 or both");
  if (options.static_equilibrium && !options.video.empty())
    throw Error("--static", "has no motion to put into " + options.video, "leave out --video");
  std::vector<std::string> sets = options.sets;
  if (!options.color.empty()) sets.push_back("display.color=" + options.color);
  if (options.wireframe) sets.push_back("display.wireframe=true");
  Opened opened = open_input(options, sets);
  Graphics graphics = open_graphics(options, false, options.width, options.height, workload_of(opened.scene, opened.model));
  Session session(graphics, std::move(opened.scene), std::move(opened.model), options.reference);
  Simulation& simulation = session.simulation;
  if (opened.replay) simulation.play(std::move(*opened.replay));
  if (session.display().color == ColorBy::error) simulation.gpu()->solve_everything();
  announce(options, graphics, simulation.model.notes);

  Framebuffer framebuffer(options.width, options.height, options.samples);
  Overlay overlay(graphics);
  long step = 0;
  const auto provenance = [&] {
    return provenance_of(simulation.scene, simulation.model, session.renderer_description(), options.command_line, step,
                         simulation.time());
  };

  if (options.static_equilibrium) {
    const reference::NewtonReport report = simulation.solve_static();
    if (!options.quiet || !report.converged) std::cerr << "fascia: " << describe(report, options.reference) << '\n';
  } else {
    const long steps = steps_to_run(options, simulation);
    const double time_step = simulation.scene.solver.time_step;
    std::optional<Recorder> recorder;
    std::vector<std::uint8_t> pixels(std::size_t{4} * options.width * options.height);
    long frame = 0;
    if (!options.video.empty()) recorder.emplace(options.video, options.width, options.height, options.fps, provenance());
    // Frame k shows the step nearest to k / fps, so that a video runs at the speed of life whatever the time step.
    const auto record_due_frames = [&] {
      while (recorder && std::lround(frame / options.fps / time_step) <= step &&
             (step < steps || frame < std::lround(steps * time_step * options.fps))) {
        draw_frame(session, overlay, framebuffer, options.panels);
        framebuffer.read_into(pixels.data());
        recorder->write(pixels);
        ++frame;
      }
    };
    record_due_frames();
    while (step < steps && !interrupted()) {
      simulation.step();
      ++step;
      if (simulation.astray()) require_sound(simulation);
      record_due_frames();
    }
    if (recorder) {
      recorder->finish();
      if (!options.quiet) std::cerr << "fascia: " << options.video << ", " << recorder->frames() << " frames\n";
    }
  }

  if (!options.out.empty()) {
    draw_frame(session, overlay, framebuffer, options.panels);
    write_png(options.out, framebuffer.read(), provenance());
    if (!options.quiet) std::cerr << "fascia: " << options.out << '\n';
  }
  return interrupted() ? exit_interrupted : exit_done;
}

}  // namespace fascia
