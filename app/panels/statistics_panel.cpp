// Numbers about the state and the run times, each with its meaning.
#include <imgui.h>

#include <algorithm>
#include <cstdio>
#include <vector>

#include "app/panels/panels.h"
#include "app/ui/style.h"
#include "app/ui/units.h"
#include "app/ui/widgets.h"
#include "gl/buffer.h"

namespace fascia {
namespace {

std::string printed(const char* format, double a, double b = 0) {
  char text[64];
  std::snprintf(text, sizeof text, format, a, b);
  return text;
}

void clock_rows(const Statistics& s, bool paused) {
  const auto milliseconds = [&](const RecentValues& history) {
    return s.measured ? printed("%.1f ms", history.median()) : "-";
  };
  const double frame = s.frame.median();
  ui::fact(
      "Frame", s.measured ? printed("%.1f ms, %.0f per second", frame, frame > 0 ? 1000 / frame : 0) : "-",
      "From picture to picture, everything included: the median of the last 30. The line below shows the last 200");
  if (s.measured) ui::plot("##frame", s.frame, 26);
  ui::fact(
      "Solve", milliseconds(s.solve),
      "One time step on the GPU: the median of the last 30 steps. In stats.json solve_ms_per_step is the median of "
      "all steps");
  if (s.measured) ui::plot("##solve", s.solve, 26);
  ui::fact("Render", milliseconds(s.render),
           "Surface, shadow and ground on the GPU: the median of the last 30 pictures");
  if (s.measured) ui::plot("##render", s.render, 26);
  ui::fact("Quality", s.quality,
           "Of moving pictures: a software renderer that is too slow saves some of their shadows. Still pictures, "
           "screenshots and videos have all; --quality full always");
  ui::fact("Real time", s.measured ? printed("%.0f %%", paused ? 0 : 100 * s.speed) : "-",
           "Simulated time over real time");
}

}  // namespace

void statistics_panel(const PanelContext& context) {
  Session& session = context.session;
  const WindowState& state = context.state;
  const Statistics& statistics = state.statistics;
  clock_rows(statistics, context.state.paused);
  if (const auto& d = statistics.diagnostics) {
    const SolverSettings& asked = session.simulation.scene.solver;
    const int granted = session.simulation.iterations_granted(), run = d->iterations.value_or(granted);
    const char* limit = run < granted ? " (tolerance)" : run < asked.iterations ? " (frame budget)" : "";
    ui::fact("Iterations", std::to_string(run) + limit,
             "Iterations of the last step, per substep, with the limit that ended them before the set number");
    ui::fact("Residual", printed("%.2g", d->residual),
             "Relative residual of the last step: 0 is an exact solution, 1 is the residual of the start");
    ui::fact("J", printed("%.3f to %.3f", d->min_det_f, d->max_det_f),
             "Smallest and largest volume of a tet over its volume at rest");
    ui::fact("Volume", printed("%.2f %%", 100 * d->volume_ratio), "Volume of all tissue, over its volume at rest");
    ui::fact("Inverted tets", std::to_string(d->inverted), "Tets turned inside out: J below 0");
    ui::fact("Largest strain", printed("%.3g", d->max_strain), "Frobenius norm of the Green strain");
    ui::fact("Largest stress", engineering(d->max_von_mises, "Pa"), "Von Mises, of a tet");
    if (const auto& peak = session.recovered.peak(); peak && session.display().color == ColorBy::recovered_von_mises)
      ui::fact("Recovered stress", engineering(peak->max, "Pa") + ", " + engineering(peak->p99, "Pa"),
               "Von Mises, at vertices, as in the picture: the largest, and the one that 1 % of the volume exceeds");
    ui::fact("Energy", engineering(d->elastic, "J") + ", " + engineering(d->kinetic, "J"),
             "Elastic, kinetic; F3 draws them over time");
    balance_rows(session.simulation, state.facts, *d);
  }
  ui::fact("Motion", session.simulation.asleep() ? "at rest, asleep" : "awake",
           "A body at rest takes no solver time until something changes (rest speed)");
  if (const GpuSolver* gpu = session.simulation.gpu()) {
    const std::size_t present = session.simulation.model.tets.size();
    ui::fact("Tets solved",
             printed("%.0f %%", 100 * gpu->share_solved() * gpu->buffers().tet_count / static_cast<double>(present)),
             "Share of all tets, on average over the steps: without fixed tets and parts at rest");
    ui::fact("Dispatches", std::to_string(gpu->dispatches_per_step()) + " per step",
             "Compute dispatches of one time step that is solved");
    ui::fact("Kernels", std::to_string(session.simulation.programs()->size()),
             "Kernels compiled so far, each specialised to the scene");
    ui::fact("Moved", bytes_text(gpu->bytes_per_iteration()) + " per iteration",
             "Estimate: the size of every buffer that a kernel uses, once");
  }
  std::string buffers = "All buffers and pictures of the program. The largest buffers:";
  std::vector<std::pair<std::size_t, std::string>> sizes;
  for (const auto& [name, bytes] : gl::bytes_by_buffer()) sizes.emplace_back(bytes, name);
  std::sort(sizes.rbegin(), sizes.rend());
  for (std::size_t i = 0; i < std::min<std::size_t>(8, sizes.size()); ++i)
    buffers += "\n" + sizes[i].second + ": " + bytes_text(static_cast<double>(sizes[i].first));
  ui::fact("GPU memory", bytes_text(static_cast<double>(gl::allocated_bytes())), buffers);
  ImGui::PushStyleColor(ImGuiCol_Text, ui::kDim);
  ImGui::TextWrapped("%s", session.renderer_description().c_str());
  ImGui::PopStyleColor();
}

}  // namespace fascia
