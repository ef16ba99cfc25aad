// What the window measures of the tissue: asks for it and shares it out, feeds the plots, chooses their point, writes
// them to files.
#include <algorithm>

#include "app/window/window.h"
#include "base/dated_name.h"
#include "shaders/shared/types.h"

namespace fascia {

void Window::read_diagnostics() {
  Statistics& s = state_.statistics;
  const bool told = state_.show_panels || state_.plots.shown || split_ || !session_->simulation.springs().empty();
  const bool due = diagnose_ && told;
  if (due) diagnose_ = false;
  if (split_) {
    if (due) split_->request_diagnostics();
    const bool news = split_->take_diagnostics(false);
    if (news && grab_in_b_) mouse_.grabs().observe(split_->diagnostics()->grab_forces);
    if (state_.editing_b) s.diagnostics = split_->diagnostics();
  }
  GpuSolver& solver = *session_->simulation.gpu();
  Plots& plots = state_.plots;
  if (plots.shown && !plots.probe) plots.probe = tip_vertex(session_->simulation.model);
  solver.set_probe(plots.shown ? plots.probe : std::nullopt);
  if (due) {
    solver.request_diagnostics();
    diagnosed_ = {diagnosed_[1], Moment{solver.time(), s.steps}};
  }
  const std::optional<Diagnostics> d = solver.take_diagnostics(false);
  if (!d) return;
  diagnostics_of_a_ = d;
  if (!grab_in_b_) mouse_.grabs().observe(d->grab_forces);
  stats_.residual = d->residual;
  follow(*d);
  if (!state_.editing_b) s.diagnostics = d;
}

void Window::follow(const Diagnostics& diagnostics) {
  Plots& plots = state_.plots;
  if (!plots.shown || plots.held) return;
  Sample sample = sample_of(diagnostics);
  sample.step = diagnosed_[diagnosed_[1].time == diagnostics.time ? 1 : 0].steps;
  if (!diagnostics.iterations) sample.iterations = session_->simulation.iterations_granted();
  if (state_.statistics.step_ms > 0) sample.step_ms = state_.statistics.step_ms;
  if (!state_.paused) sample.frame_ms = state_.statistics.frame.latest();
  plots.history.add(sample);
}

bool Window::choose_probe(const Eigen::Vector2d& at) {
  Plots& plots = state_.plots;
  if (!plots.shown || !plots.choosing) return false;
  plots.choosing = false;
  GpuSolver& solver = *session_->simulation.gpu();
  solver.publish();
  std::vector<Eigen::Vector3d> positions;
  for (const shared::vec4& p : solver.positions().read<shared::vec4>()) positions.emplace_back(p.x, p.y, p.z);
  const Ray ray = session_->camera.ray(at.x(), at.y(), framebuffer_->width(), framebuffer_->height());
  const auto hit = pick_nearest(ray, session_->surface().triangles, positions, shown_cut(session_->look));
  if (!hit) return true;
  // What is drawn may be embedded; what is followed is a vertex of the tets.
  const std::vector<Tet>& tets = session_->simulation.model.tets;
  double nearest = 1e300;
  for (const Tet& tet : tets)
    for (const std::uint32_t v : tet)
      if (const double distance = (positions[v] - hit->point).squaredNorm(); distance < nearest) {
        nearest = distance;
        plots.probe = v;
      }
  plots.history.clear();  // of another vertex
  diagnose_ = true;
  return true;
}

void Window::write_plots(const Requests& requests) {
  const Plots& plots = state_.plots;
  if (requests.plot_table && plots.probe) {
    const std::filesystem::path path = dated_name(".csv");
    write_samples(path, plots.history.between(plots.right_edge() - plots.span, plots.right_edge()),
                  session_->simulation.model, provenance(), *plots.probe);
    say(path.string());
  }
  if (!requests.plot_picture) return;
  const Image whole = framebuffer_->read();
  const int left = std::clamp(static_cast<int>(plots.left), 0, whole.width - 1),
            top = std::clamp(static_cast<int>(plots.top), 0, whole.height - 1);
  Image part{std::min(static_cast<int>(plots.width), whole.width - left),
             std::min(static_cast<int>(plots.height), whole.height - top),
             {}};
  for (int y = top; y < top + part.height; ++y) {
    const auto row = whole.rgba.begin() + 4 * (static_cast<std::ptrdiff_t>(y) * whole.width + left);
    part.rgba.insert(part.rgba.end(), row, row + 4 * part.width);
  }
  const std::filesystem::path path = dated_name(".png");
  write_png(path, part, provenance());
  say(path.string());
}

}  // namespace fascia
