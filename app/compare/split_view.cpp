#include "app/compare/split_view.h"

#include <imgui.h>

#include <algorithm>
#include <cstdio>

#include "app/panels/panels.h"
#include "app/ui/style.h"
#include "app/ui/units.h"
#include "app/ui/widgets.h"
#include "base/error.h"
#include "sim/material/tissues.h"

namespace fascia {
namespace {

constexpr int kDivider = 2;  // [pixels]

std::string material_text(const Material& m) {
  if (const Tissue* tissue = tissue_of(m)) return tissue->label;
  return "E " + engineering(m.young_modulus, "Pa") + ", nu " + engineering(m.poisson_ratio, "") +
         (m.damping > 0 ? ", damping " + engineering(m.damping, "s") : "");
}

}  // namespace

std::string side_result(const Session& session, const std::optional<Diagnostics>& diagnostics, double step_ms,
                        bool measured) {
  char text[64];
  std::string result;
  if (const auto& error = session.true_error.result(); error && error->converged) {
    std::snprintf(text, sizeof text, "true error %.2g %%", 100 * error->relative);
    result = text;
  } else if (diagnostics) {
    std::snprintf(text, sizeof text, "residual %.2g", diagnostics->residual);
    result = text;
  }
  const char* separator = result.empty() ? "" : "  |  ";
  if (measured && session.simulation.asleep()) {
    result += std::string(separator) + "at rest, asleep";
  } else if (measured && step_ms > 0) {
    std::snprintf(text, sizeof text, "%s%.1f ms a step", separator, step_ms);
    result += text;
  }
  if (diagnostics && !session.simulation.gpu()->springs().empty())
    result += (result.empty() ? "" : "  |  ") + engineering(diagnostics->grab_force.norm(), "N");
  return result;
}

namespace {

// The first material that differs from the other side's.
std::optional<std::size_t> first_other_material(const Model& model, const Model& other) {
  for (std::size_t i = 0; i < model.materials.size(); ++i)
    if (i >= other.materials.size() || model.materials[i] != other.materials[i]) return i;
  return std::nullopt;
}

// "Two-level, Subspace, 10 iterations", and that material.
std::string side_text(const Session& session, const Session& other) {
  const SolverSettings& s = session.simulation.scene.solver;
  std::string text = label_of(s.method);
  if (s.acceleration != Acceleration::none) text += std::string(", ") + label_of(s.acceleration);
  text += ", " + std::to_string(s.iterations) + (s.iterations == 1 ? " iteration" : " iterations");
  if (s.substeps > 1) text += ", " + std::to_string(s.substeps) + " substeps";
  const Model& model = session.simulation.model;
  if (const auto i = first_other_material(model, other.simulation.model))
    text +=
        "\n" + (model.materials.size() > 1 ? model.material_names[*i] + ": " : "") + material_text(model.materials[*i]);
  return text;
}

}  // namespace

SplitView::SplitView(Graphics& graphics, const Session& a, Scene scene, Model model) : shared_(shared_of(a)) {
  const auto fail = [&](const char* what, const char* expected) { throw Error(scene.file.string(), what, expected); };
  if (a.simulation.uses_reference()) fail("the reference solver has no settings to compare", "leave out --reference");
  if (model.rest_positions.size() != a.simulation.model.rest_positions.size() ||
      model.tets.size() != a.simulation.model.tets.size())
    fail("the second side has another mesh", "expected settings and materials of the same bodies");
  b_ = std::make_unique<Session>(graphics, std::move(scene), std::move(model), false);
  apply(shared_, *b_);
  b_->simulation.set_start(a.simulation.start());
  b_->extent = a.extent;
  restart_from(a);
}

SplitView::Shared SplitView::shared_of(const Session& session) {
  return {session.display(), session.simulation.scene.gravity, session.simulation.scene.solver.time_step};
}

void SplitView::apply(const Shared& shared, Session& session) {
  const Shared now = shared_of(session);
  if (now.display != shared.display) session.set_display(shared.display);
  if (now.gravity != shared.gravity) session.simulation.set_gravity(shared.gravity);
  if (now.time_step == shared.time_step) return;
  SolverSettings settings = session.simulation.scene.solver;
  settings.time_step = shared.time_step;
  session.simulation.set_settings(settings);
}

void SplitView::share(Session& a) {
  const Shared of_a = shared_of(a), of_b = shared_of(*b_);
  if (of_a == shared_ && of_b == shared_) return;
  shared_ = of_a == shared_ ? of_b : of_a;
  apply(shared_, a);
  apply(shared_, *b_);
}

void SplitView::restart_from(const Session& a) {
  b_->simulation.go_on_from(a.simulation.state());
  b_->forget_errors();
  diagnostics_.reset();
}

void SplitView::reset(Session& a) {
  follow(a, [&] { a.simulation.reset(); });
  restart_from(a);
}

void SplitView::swap(std::unique_ptr<Session>& a) {
  std::swap(a, b_);
  std::swap(sides_[0].step_ms, sides_[1].step_ms);
  diagnostics_.reset();
}

void SplitView::make_step(Session& session, Side& side) {
  if (session.simulation.asleep()) {  // its time is not that of a step
    session.simulation.step();
    return;
  }
  side.timer.begin();
  session.simulation.step();
  side.timer.end();
  while (const auto took = side.timer.take())
    side.step_ms = side.step_ms > 0 ? 0.9 * side.step_ms + 0.1 * took->milliseconds : took->milliseconds;
}

void SplitView::follow(Session& a, const std::function<void()>& change_a) {
  const std::vector<Material> before = a.simulation.model.materials;
  const SolverSettings settings = a.simulation.scene.solver;
  const double time = a.simulation.time();
  change_a();
  const std::vector<Material>& materials = a.simulation.model.materials;
  Simulation& b = b_->simulation;
  if (b.scene.solver == settings && a.simulation.scene.solver != settings) b.set_settings(a.simulation.scene.solver);
  for (std::size_t i = 0; i < std::min(before.size(), b.model.materials.size()); ++i)
    if (b.model.materials[i] == before[i] && materials[i] != before[i]) b.set_material(i, materials[i]);
  share(a);
  b.gpu()->finish_background();  // otherwise the step that takes the result would depend on timing
  if (a.simulation.time() < time) restart_from(a);
}

void SplitView::lead(Session& a, Session& grab) {
  const bool led_by_a = &grab == &a || a.simulation.replaying();  // a replay's grabs are at A, wherever the mouse is
  Simulation &leads = led_by_a ? a.simulation : b_->simulation, &follows = led_by_a ? b_->simulation : a.simulation;
  follows.set_grab(leads.asked_springs());
  for (const LedTool& tool : leads.led_tools()) follows.lead(tool);
}

void SplitView::step(Session& a, Session& grab) {
  if (a.simulation.repeating()) follow(a, [&] { a.simulation.repeat_inputs(); });
  lead(a, grab);
  const double time = a.simulation.time();
  make_step(a, sides_[0]);
  make_step(*b_, sides_[1]);
  if (a.simulation.time() < time) restart_from(a);  // a replay that ends with a reset
  if (!b_->simulation.diverged()) return;
  ++lost_;  // a divergence of B must not stop A: B continues from the valid state of A
  b_->simulation.back_to_valid();
  b_->simulation.begin_anew();
}

bool SplitView::take_diagnostics(bool wait) {
  std::optional<Diagnostics> taken = b_->simulation.gpu()->take_diagnostics(wait);
  if (!taken) return false;
  diagnostics_ = std::move(taken);
  return true;
}

MarkArea SplitView::area_of(ImDrawList& list, const Area& area, int height, float scale) {
  return {list, static_cast<float>(area.x) / scale, static_cast<float>(area.width) / scale,
          static_cast<float>(height) / scale};
}

std::array<SplitView::Area, 2> SplitView::areas(int width, const Margins& margins) {
  const int left = static_cast<int>(margins.left), right = static_cast<int>(margins.right),
            legend = static_cast<int>(margins.legend_left),
            each = std::max(1, (width - left - legend - right - kDivider) / 2);
  const int begin = left + legend + each + kDivider;
  return {Area{left, legend + each}, Area{begin, right > 0 ? width - begin : each}};
}

Framebuffer& SplitView::picture_of(int width, int height, int samples) {
  for (const std::unique_ptr<Framebuffer>& picture : pictures_)
    if (picture && picture->width() == width && picture->height() == height && picture->samples() == samples)
      return *picture;
  std::swap(pictures_[0], pictures_[1]);
  pictures_[0].reset();  // before the new one, since memory may not suffice for both
  pictures_[0] = std::make_unique<Framebuffer>(width, height, samples);
  return *pictures_[0];
}

SplitView::SideGrabs SplitView::grabs(const Session& a, const std::optional<Diagnostics>& of_a,
                                      const GrabSet* of_user) const {
  const auto marks = [&](const Session& side, const std::optional<Diagnostics>& diagnostics) {
    return grab_marks(side.simulation, diagnostics ? diagnostics->grab_forces : std::vector<GrabForce>(), of_user);
  };
  return {marks(a, of_a), marks(*b_, diagnostics_)};
}

void SplitView::draw(Session& a, Framebuffer& framebuffer, const Margins& margins, const SideGrabs& grabs,
                     const std::function<void(std::size_t, const Framebuffer&)>& drawn) {
  b_->camera = a.camera;
  b_->look = a.look;  // one scale for both sides
  framebuffer.bind_resolved();
  gl::Disable(GL_SCISSOR_TEST);
  gl::ClearColor(ui::kPanel.x, ui::kPanel.y, ui::kPanel.z, 1);
  gl::Clear(GL_COLOR_BUFFER_BIT);
  const std::array<Area, 2> places = areas(framebuffer.width(), margins);
  const int each = std::min(places[0].width, places[1].width);  // the side with the legend is wider
  for (std::size_t i = 0; i < 2; ++i) {
    const double legend = places[i].width - each;
    frame_picture(i == 0 ? a.camera : b_->camera, a.extent,
                  {places[i].width,
                   framebuffer.height(),
                   {.right = i == 0 ? 0 : legend, .bottom = margins.bottom, .legend_left = i == 0 ? legend : 0},
                   true});
    Framebuffer& picture = picture_of(places[i].width, framebuffer.height(), framebuffer.samples());
    (i == 0 ? a : *b_).draw(picture, arrows(grabs[i]));
    if (drawn) drawn(i, picture);
    picture.copy_to(framebuffer, places[i].x);
  }
}

void SplitView::draw_labels(ImDrawList& list, const Session& a, int width, int height, const Margins& margins,
                            float scale, const Labels& labels) const {
  const std::array<Area, 2> places = areas(width, margins);
  const float bottom = static_cast<float>(height) / scale, line = static_cast<float>(places[1].x - kDivider) / scale;
  list.AddRectFilled({line, 0}, {static_cast<float>(places[1].x) / scale, bottom}, ImGui::GetColorU32(ui::kAccent));
  const float free_bottom = bottom - static_cast<float>(margins.bottom) / scale;
  for (std::size_t i = 0; i < 2; ++i) {
    const Session &session = i == 0 ? a : *b_, &other = i == 0 ? *b_ : a;
    const int each = std::min(places[0].width, places[1].width), legend = i == 0 ? places[0].width - each : 0;
    const float left = static_cast<float>(places[i].x + legend) / scale, room = static_cast<float>(each) / scale;
    const float middle = left + 0.5f * room, widest = room - ui::px(40);
    LabelPlaces free({left, 0, left + room, free_bottom}, ui::px(kLabelGap));
    for (const Box& box : labels.covered) free.keep_clear(box);
    const bool edited = labels.measured && (i == 1) == labels.editing_b;  // only the window can edit
    free.keep_clear(ui::pill(list, (i == 0 ? "A   " : "B   ") + side_text(session, other), middle, ui::px(46),
                             edited ? ui::kAccent : ui::kText, widest));
    std::string result = side_result(session, i == 0 ? labels.of_a : diagnostics_, sides_[i].step_ms, labels.measured);
    if (i == 1 && lost_ > 0) result += "  |  diverged " + std::to_string(lost_) + (lost_ == 1 ? " time" : " times");
    if (!result.empty()) free.keep_clear(ui::pill(list, result, middle, free_bottom - ui::px(78), ui::kText, widest));
    draw_grab_marks(area_of(list, places[i], height, scale), session, labels.grabs[i], free);
  }
}

}  // namespace fascia
