#include "app/headless.h"

#include <iostream>

#include "app/breakdown.h"
#include "app/color_bar.h"
#include "app/interrupt.h"

namespace fascia {
namespace {

Opened open_with_display(const RenderOptions& options) {
  std::vector<std::string> sets = options.sets;
  if (!options.color.empty()) sets.push_back("display.color=" + options.color);
  if (options.wireframe) sets.push_back("display.wireframe=true");
  return open_input(options, sets);
}

}  // namespace

Headless::Headless(const RenderOptions& options) : Headless(options, open_with_display(options)) {}

Headless::Headless(const RenderOptions& options, Opened opened)
    : options_(options),
      graphics_(open_graphics(options, false, options.width, options.height, workload_of(opened.scene, opened.model))),
      session_(graphics_, std::move(opened.scene), std::move(opened.model), options.reference),
      framebuffer_(options.width, options.height, options.samples),
      overlay_(graphics_) {
  Simulation& simulation = session_.simulation;
  if (opened.replay) simulation.play(std::move(*opened.replay));
  if (session_.display().color == ColorBy::error) simulation.gpu()->solve_everything();
  if (!options.static_equilibrium) steps_ = steps_to_run(options, simulation);
  announce(options, graphics_, simulation.model.notes);
}

void Headless::run(const std::function<void()>& after_step) {
  Simulation& simulation = session_.simulation;
  if (options_.static_equilibrium) {
    const reference::NewtonReport report = simulation.solve_static();
    if (!options_.quiet || !report.converged) std::cerr << "fascia: " << describe(report, options_.reference) << '\n';
    return;
  }
  if (after_step) after_step();
  while (step_ < steps_ && !interrupted()) {
    simulation.step();
    ++step_;
    if (simulation.astray()) require_sound(simulation);
    if (after_step) after_step();
  }
}

Framebuffer& Headless::draw() {
  require_sound(session_.simulation);
  GpuSolver& solver = *session_.simulation.gpu();
  solver.request_diagnostics();
  const std::optional<Diagnostics> diagnostics = solver.take_diagnostics(true);
  if (session_.display().color == ColorBy::error) session_.measure_error();
  session_.settle_range();
  const std::vector<HandMark> hands = hand_marks(session_.simulation, diagnostics ? diagnostics->hand_forces : std::vector<HandForce>(), nullptr);
  session_.draw(framebuffer_, arrows(hands));
  if (options_.panels || has_legend(session_) || !hands.empty())
    overlay_.draw_headless(session_, framebuffer_, options_.panels, diagnostics, hands);
  return framebuffer_;
}

Provenance Headless::provenance() const {
  const Simulation& simulation = session_.simulation;
  return provenance_of(simulation.scene, simulation.model, session_.renderer_description(), options_.command_line, step_,
                       simulation.time());
}

Outcome Headless::outcome() {
  const Simulation& simulation = session_.simulation;
  Image picture = draw().read();
  return {std::move(picture), provenance(), simulation.model.file_mesh,
          reference::export_fields(simulation.model, simulation.state()), simulation.gpu()->buffers().size};
}

}  // namespace fascia
