#include "app/window/observer.h"

#include <algorithm>
#include <utility>

#include "app/state/deformed_positions.h"
#include "base/dated_name.h"
#include "base/error.h"
#include "sim/output/measured_samples.h"
#include "sim/visual/picking.h"

namespace fascia {

void Observer::read() {
  WindowState& state = stage_.state;
  Statistics& s = state.statistics;
  SplitView* const split = sides_.split();
  const bool shown = state.show_panels || state.plots.shown || split || !stage_.simulation().springs().empty() ||
                     !stage_.simulation().scene.tools.instruments.empty();
  const bool due = stage_.diagnose && shown;
  if (due) stage_.diagnose = false;
  if (split) {
    if (due) split->request_diagnostics();
    const bool news = split->take_diagnostics(false);
    if (news && sides_.grab_in_b()) stage_.mouse.grabs().observe(split->diagnostics()->grab_forces);
    if (state.editing_b) s.diagnostics = split->diagnostics();
    if (news && state.editing_b) state.instruments.readings.add(s.diagnostics->time, s.diagnostics->tool_loads);
  }
  GpuSolver& solver = *stage_.simulation().gpu();
  Plots& plots = state.plots;
  if (plots.shown && !plots.probe) plots.probe = tip_vertex(stage_.simulation().model);
  solver.set_probe(plots.shown ? plots.probe : std::nullopt);
  if (due) {
    solver.request_diagnostics();
    asked_ = {asked_[1], Moment{solver.time(), s.steps}};
  }
  std::optional<Diagnostics> d = solver.take_diagnostics(false);
  if (!d) return;
  stage_.simulation().correct_contact(d);
  open_ = d;
  if (!sides_.grab_in_b()) stage_.mouse.grabs().observe(d->grab_forces);
  residual_ = d->residual;
  follow(*d);
  if (state.editing_b) return;
  s.diagnostics = d;
  state.instruments.readings.add(d->time, d->tool_loads);
}

void Observer::finish() {
  GpuSolver& solver = *stage_.simulation().gpu();
  if (stage_.diagnose) solver.request_diagnostics();
  if (auto last = solver.take_diagnostics(true)) {
    stage_.simulation().correct_contact(last);
    open_ = last;
    residual_ = last->residual;
  }
}

void Observer::follow(const Diagnostics& diagnostics) {
  const WindowState& state = stage_.state;
  Plots& plots = stage_.state.plots;
  if (!plots.shown || plots.held) return;
  Sample sample = sample_of(diagnostics);
  sample.step = asked_[asked_[1].time == diagnostics.time ? 1 : 0].steps;
  if (!diagnostics.iterations) sample.iterations = stage_.simulation().iterations_granted();
  if (state.statistics.step_ms > 0) sample.step_ms = state.statistics.step_ms;
  if (!state.paused) sample.frame_ms = state.statistics.frame.latest();
  plots.history.add(sample);
}

bool Observer::choose_probe(const Eigen::Vector2d& at) {
  Plots& plots = stage_.state.plots;
  if (!plots.shown || !plots.choosing) return false;
  plots.choosing = false;
  Session& session = *stage_.session;
  const std::vector<Eigen::Vector3d> positions = deformed_positions(session);
  const Ray ray = session.camera.ray(at.x(), at.y(), stage_.framebuffer->width(), stage_.framebuffer->height());
  const auto hit = pick_nearest(ray, session.surface().triangles, positions, shown_cut(session.look));
  if (!hit) return true;
  // The drawn surface may be embedded; the plots follow a vertex of the tets.
  const std::vector<Tet>& tets = session.simulation.model.tets;
  double nearest = 1e300;
  for (const Tet& tet : tets)
    for (const std::uint32_t v : tet)
      if (const double distance = (positions[v] - hit->point).squaredNorm(); distance < nearest) {
        nearest = distance;
        plots.probe = v;
      }
  plots.history.clear();  // the samples are of another vertex
  stage_.diagnose = true;
  return true;
}

void Observer::show_measured(const std::filesystem::path& file) {
  Plots& plots = stage_.state.plots;
  const Model& model = stage_.simulation().model;
  MeasurementRead how{plots.probe.value_or(tip_vertex(model)), {}, {}};
  for (const Column& column : sample_columns()) how.passed_over.push_back(column.name);
  const Measurement measurement = read_measurement(file, model, how);
  std::uint32_t probe = how.probe;
  for (const MeasuredCurve& curve : measurement.curves)
    if (curve.name.starts_with("probe_")) probe = static_cast<std::uint32_t>(curve.measurand.index);
  std::vector<Sample> samples = measured_samples(measurement, model.tools.size(), probe);
  if (samples.empty())
    throw Error(file.string(), "has no curve over time that the plots show",
                "expected time_s and reaction_y_N, grab_y_N, contact_NAME_y_N or probe_y_m");
  if (plots.probe && plots.probe != probe) plots.history.clear();  // whose samples are of another vertex
  plots.probe = probe;
  plots.measured = std::move(samples);
  end_fit();
  plots.measured_file = std::filesystem::absolute(file);
  plots.fit.found.clear();
  plots.fit.line.clear();
  plots.shown = true;
  stage_.diagnose = true;
  stage_.messages.say(file.string() + ": dashed in the plots");
}

void Observer::start_fit(const std::filesystem::path& program) {
  Plots& plots = stage_.state.plots;
  FitPanel& fit = plots.fit;
  if (fit.keys.empty()) throw Error("Fit", "has no free values", "choose some first");
  fit.found.clear();
  fit.failed = false;
  fit.line = "begins";
  fit_.emplace(program, stage_.scene_to_save(true),
               FitTask{plots.measured_file, fit.keys, *plots.probe, fit.equilibria});
  fit.running = true;
}

bool Observer::follow_fit() {
  if (!fit_) return false;
  FitPanel& fit = stage_.state.plots.fit;
  const bool ended = fit_->ended();
  const std::string before = std::exchange(fit.line, fit_->last_line());
  if (!ended) return fit.line != before;
  fit.running = false;
  const std::optional<std::vector<Estimate>> found = fit_->found();
  fit.failed = !found;
  fit.found = found.value_or(std::vector<Estimate>());
  fit.line = found ? "The fit has ended" : fit.line.empty() ? "The fit was ended" : fit.line;
  fit_.reset();
  return true;
}

void Observer::end_fit() {
  fit_.reset();
  FitPanel& fit = stage_.state.plots.fit;
  if (!std::exchange(fit.running, false)) return;
  fit.line = "canceled";
}

void Observer::write_plots(const Requests& requests) {
  const Plots& plots = stage_.state.plots;
  if (requests.plot_table && plots.probe) {
    const std::filesystem::path path = dated_name(".csv");
    write_samples(path, plots.history.between(plots.right_edge() - plots.span, plots.right_edge()),
                  stage_.simulation().model, stage_.provenance(), *plots.probe);
    stage_.messages.say(path.string());
  }
  if (!requests.plot_picture) return;
  const Image whole = stage_.framebuffer->read();
  const int left = std::clamp(static_cast<int>(plots.left), 0, whole.width - 1),
            top = std::clamp(static_cast<int>(plots.charts_top), 0, whole.height - 1),
            bottom = std::clamp(static_cast<int>(plots.top + plots.height), top + 1, whole.height);
  Image part{std::min(static_cast<int>(plots.width), whole.width - left), bottom - top, {}};
  for (int y = top; y < top + part.height; ++y) {
    const auto row = whole.rgba.begin() + 4 * (static_cast<std::ptrdiff_t>(y) * whole.width + left);
    part.rgba.insert(part.rgba.end(), row, row + 4 * part.width);
  }
  const std::filesystem::path path = dated_name(".png");
  write_png(path, part, stage_.provenance());
  stage_.messages.say(path.string());
}

}  // namespace fascia
