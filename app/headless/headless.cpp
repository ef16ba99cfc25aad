#include "app/headless/headless.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>
#include <sstream>

#include "app/cli/picture_preset.h"
#include "app/headless/interpolated_frames.h"
#include "app/overlay/color_bar.h"
#include "app/panels/panels.h"
#include "base/error.h"
#include "base/interrupt.h"
#include "sim/replay/replay_time.h"
#include "sim/simulation/divergence.h"

namespace fascia {
namespace {

// `split`: additional sets for the second side in one text, separated by semicolons.
Opened open_with_display(const RenderOptions& options, const std::string& split = "") {
  std::vector<std::string> sets = preset_sets(options.preset);
  sets.insert(sets.end(), options.sets.begin(), options.sets.end());
  std::istringstream parts(split);
  for (std::string part; std::getline(parts, part, ';');)
    if (!part.empty()) sets.push_back(part);
  if (!options.color.empty()) sets.push_back("display.color=" + options.color);
  if (options.wireframe) sets.push_back("display.wireframe=true");
  return open_input(options, sets);
}

Opened nudged(Opened opened, double nudge) {
  if (nudge == 0) return opened;
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& x : opened.model.rest_positions) box.extend(x);
  const double most = nudge * box.diagonal().norm();
  std::mt19937 random;  // whose numbers are the same everywhere
  const auto number = [&] { return 2.0 * random() / std::mt19937::max() - 1; };
  for (Eigen::Vector3d& x : opened.model.rest_positions) x += most * Eigen::Vector3d(number(), number(), number());
  return opened;
}

CameraSettings settings_of(const Camera& camera) { return {camera.eye, camera.target, camera.up, camera.fov_deg}; }

std::vector<GrabMark> marks_of(const Simulation& simulation, const std::optional<Diagnostics>& diagnostics) {
  return grab_marks(simulation, diagnostics ? diagnostics->grab_forces : std::vector<GrabForce>(), nullptr);
}

}  // namespace

Headless::Headless(const RenderOptions& options, double nudge)
    : Headless(options, nudged(open_with_display(options), nudge)) {}

Headless::Headless(const RenderOptions& options, Opened opened)
    : options_(options),
      graphics_(open_graphics(options, false, options.width, options.height,
                              workload_of(opened.scene, opened.model, options.static_equilibrium))),
      session_(graphics_, std::move(opened.scene), std::move(opened.model), options.reference),
      picture_(options.width, options.height, options.samples),
      camera_(options.camera, session_.simulation.scene, opened.replay ? &*opened.replay : nullptr,
              settings_of(session_.camera)),
      opened_(session_.display()),
      overlay_(graphics_) {
  Simulation& simulation = session_.simulation;
  // Display settings from the options apply to the whole replay.
  const auto names_display = [](const std::string& set) { return set.starts_with("display."); };
  const bool chosen = !options.color.empty() || options.wireframe || !options.preset.empty() ||
                      std::any_of(options.sets.begin(), options.sets.end(), names_display);
  if (opened.replay && !chosen) view_ = ReplayView(*opened.replay);
  if (opened.replay) simulation.play(std::move(*opened.replay));
  if (session_.display().color == ColorBy::error) simulation.gpu()->solve_everything();
  if (!options.split.empty()) {
    Opened other = open_with_display(options, options.split);
    const Scene &a = session_.simulation.scene, &b = other.scene;
    if (a.gravity != b.gravity || a.display != b.display || a.solver.time_step != b.solver.time_step)
      throw Error("--split " + options.split, "changes gravity, the time step or the display, which both sides share",
                  "expected them in --set");
    split_.emplace(graphics_, session_, std::move(other.scene), std::move(other.model));
    if (session_.display().color == ColorBy::error) split_->b().simulation.gpu()->solve_everything();
  }
  if (!options.static_equilibrium) steps_ = steps_to_run(options, simulation);
  session_.range_only_grows = !options.video.empty();
  start_camera(simulation.replay() ? ReplayTime(*simulation.replay()).seconds(steps_)
                                   : static_cast<double>(steps_) * simulation.scene.solver.time_step);
  announce(options, graphics_, simulation.model.notes);
}

// Points the camera for the first picture of so many simulated seconds, and reserves space for all directions from
// which a moving camera sees the body, so that the framing does not change.
void Headless::start_camera(double seconds) {
  if (!options_.turntable.empty()) {
    const Turntable turntable = parse_turntable(options_.turntable);
    constexpr double kTurn = 360;  // [degrees]
    if (turntable.seconds)
      camera_.turn(kTurn * options_.slow / *turntable.seconds);
    else if (seconds > 0)
      camera_.turn(turntable.degrees / seconds);
    camera_seconds_ = turntable.seconds.value_or(0) / options_.slow;
  }
  camera_seconds_ = std::max(camera_seconds_, camera_.end());
  session_.look_from(camera_.at(0, 0));
  session_.measure_extent();
  if (!camera_.moves()) return;
  constexpr int kDirections = 48;
  Eigen::Vector2d widest = session_.extent;
  const double all = std::max(seconds, camera_seconds_);
  for (int k = 1; k <= kDirections; ++k) {
    session_.look_from(camera_.at(0, all * k / kDirections));
    session_.measure_extent();
    widest = {std::min(widest.x(), session_.extent.x()), std::max(widest.y(), session_.extent.y())};
  }
  session_.extent = widest;
  session_.look_from(camera_.at(0, 0));
}

void Headless::run(const std::function<void()>& after_step) {
  Simulation& simulation = session_.simulation;
  if (options_.static_equilibrium) {
    const auto settle = [&](Simulation& side) {
      const StaticReport report = side.solve_static(static_news(options_.quiet), interrupt_token());
      if (interrupted()) return;
      require_equilibrium(side, report);
      if (!options_.quiet) std::cerr << "fascia: " << describe(report) << '\n';
    };
    settle(simulation);
    if (split_) settle(split_->b().simulation);
    return;
  }
  if (after_step) after_step();
  while (step_ < steps_ && !interrupted()) {
    if (split_)
      split_->step(session_, session_);
    else
      simulation.step();
    ++step_;
    if (simulation.diverged()) require_valid(simulation);
    if (after_step) after_step();
  }
}

void Headless::show_as_of(double step) {
  const DisplaySettings display = view_.display(step).value_or(opened_);
  if (display != session_.display()) session_.set_display(display);
}

void Headless::look(double step, double time) {
  show_as_of(step);
  session_.look_from(camera_.at(step, time));
}

Framebuffer& Headless::draw() {
  require_valid(session_.simulation);
  session_.forget_range();
  session_.forget_ground();
  const double step = static_cast<double>(step_), time = session_.simulation.simulated();
  if (camera_.framed()) {
    session_.frame_with_motion();
    camera_.reframe(settings_of(session_.camera));
  }
  return draw(step, time, nullptr);
}

Framebuffer& Headless::draw(double step, double time, const gl::Buffer* positions) {
  look(step, time);
  if (split_) split_->share(session_);
  const bool tells = options_.panels || split_;
  const std::optional<Diagnostics> diagnostics = tells ? diagnose() : diagnose_grabs();
  session_.measure_error();
  if (split_) split_->b().measure_error();
  session_.settle_range(split_ ? &split_->b() : nullptr);
  session_.settle_ground(split_ ? &split_->b() : nullptr);
  if (split_) return draw_split(diagnostics);
  std::vector<GrabMark> grabs = marks_of(session_.simulation, diagnostics);
  if (positions && !remembered_grabs_.empty()) {
    constexpr double kRounding = 1e-6;  // a whole step may be slightly less because of rounding
    const auto ago = static_cast<std::size_t>(step_ - static_cast<long>(std::floor(step + kRounding)));
    grabs = remembered_grabs_[remembered_grabs_.size() - 1 - std::min(ago, remembered_grabs_.size() - 1)];
  }
  const int width = picture_.framebuffer().width(), height = picture_.framebuffer().height();
  if (options_.panels || has_legend(session_)) scale_overlay();
  frame_picture(session_.camera, session_.extent, {width, height, margins(height >= kLeastRows)});
  Framebuffer& framebuffer =
      picture_.draw(session_.camera, [&](Framebuffer& target) { session_.draw(target, arrows(grabs), positions); });
  if (options_.panels || has_legend(session_) || !grabs.empty())
    overlay_.draw_headless(session_, framebuffer, options_.panels, diagnostics, grabs);
  return framebuffer;
}

void Headless::scale_overlay() {
  overlay_.set_legend_font(session_.display().legend.font_size);
  overlay_.scale_to(picture_.framebuffer().height());
}

Margins Headless::margins(bool legend) {
  const Framebuffer& picture = picture_.framebuffer();
  const double panels = options_.panels ? panel_space() : 0;
  return legend ? legend_margins(session_, picture.width(), picture.height(), 1, panels) : Margins{panels};
}

std::optional<Diagnostics> Headless::diagnose() {
  GpuSolver& solver = *session_.simulation.gpu();
  solver.request_diagnostics();
  std::optional<Diagnostics> diagnostics = solver.take_diagnostics(true);
  session_.simulation.correct_contact(diagnostics);
  return diagnostics;
}

std::optional<Diagnostics> Headless::diagnose_grabs() {
  return session_.simulation.springs().empty() ? std::nullopt : diagnose();
}

void Headless::remember_grabs() {
  remembered_grabs_.push_back(marks_of(session_.simulation, diagnose_grabs()));
  if (remembered_grabs_.size() > InterpolatedFrames::kAhead + 2) remembered_grabs_.pop_front();
}

Framebuffer& Headless::draw_split(const std::optional<Diagnostics>& diagnostics) {
  scale_overlay();
  const Margins edges = margins(true);
  split_->request_diagnostics();
  split_->take_diagnostics(true);
  const SplitView::SideGrabs grabs = split_->grabs(session_, diagnostics, nullptr);
  Framebuffer& framebuffer =
      picture_.draw(session_.camera, [&](Framebuffer& target) { split_->draw(session_, target, edges, grabs); });
  overlay_.draw_headless(session_, framebuffer, options_.panels, diagnostics, {}, [&] {
    split_->draw_labels(*ImGui::GetBackgroundDrawList(), session_, framebuffer.width(), framebuffer.height(), edges, 1,
                        {diagnostics, false, false, grabs, overlay_.covered()});
  });
  return framebuffer;
}

Provenance Headless::provenance() const {
  const Simulation& simulation = session_.simulation;
  return provenance_of(simulation.scene, simulation.model, session_.renderer_description(), options_.command_line,
                       step_, simulation.time());
}

Outcome Headless::outcome() {
  const Simulation& simulation = session_.simulation;
  Image picture = draw().read();
  Outcome outcome{std::move(picture), provenance(), simulation.model.file_mesh,
                  reference::export_fields(simulation.model, simulation.state()), simulation.gpu()->buffers().size};
  const std::vector<Tool>& tools = simulation.model.tools;
  if (tools.empty()) return outcome;
  const std::vector<ToolLoad> loads = diagnose()->tool_loads;
  for (std::size_t t = 0; t < tools.size(); ++t) outcome.contact.emplace_back(tools[t].name, loads[t].force);
  return outcome;
}

}  // namespace fascia
