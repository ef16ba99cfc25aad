#include "app/session.h"

#include <algorithm>
#include <cmath>

namespace fascia {
namespace {

// The next 1, 2 or 5 times a power of ten.
double round_up(double value) {
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  for (const double step : {1.0, 2.0, 5.0})
    if (value <= step * decade) return step * decade;
  return 10 * decade;
}

}  // namespace

Session::Session(Graphics& graphics, Scene scene, Model built, bool use_reference, const Progress& progress)
    : simulation(std::move(scene), std::move(built), graphics.programs.get(), use_reference, progress),
      surface_(drawn_surface(simulation.scene, simulation.model)),
      renderer_(*graphics.programs, surface_.triangles, static_cast<std::uint32_t>(surface_.rest_positions.size()),
                simulation.model.fixed, surface_.rest_positions),
      description_(describe(graphics)) {
  const Model& model = simulation.model;
  box_min_.setConstant(1e300);
  box_max_.setConstant(-1e300);
  for (const Tet& tet : model.tets)
    for (const std::uint32_t v : tet) {
      box_min_ = box_min_.cwiseMin(model.rest_positions[v]);
      box_max_ = box_max_.cwiseMax(model.rest_positions[v]);
    }
  look.center = 0.5 * (box_min_ + box_max_);
  look.radius = 0.5 * (box_max_ - box_min_).norm();
  look.ground_height = box_min_.y() - 0.4 * look.radius;
  if (const auto& view = simulation.scene.camera) {
    camera.eye = view->eye;
    camera.target = view->target;
    camera.up = view->up;
    camera.fov_deg = view->fov_deg;
  } else {
    frame();
  }
  set_display(simulation.scene.display);
}

void Session::frame() { camera.frame(box_min_, box_max_); }

void Session::set_display(const DisplaySettings& display) {
  simulation.scene.display = display;
  simulation.gpu()->set_color(display.color);
  look.wireframe = display.wireframe;
  look.heat_map = display.color != ColorBy::none;
  if (display.range) look.range = display.range->cast<float>();
  if (display.color == ColorBy::error && true_error.result()) show_error();
}

void Session::follow_range(const Diagnostics& d) {
  if (display().color == ColorBy::strain) follow_largest(d.max_strain);
  if (display().color == ColorBy::von_mises) follow_largest(d.max_von_mises);
}

void Session::follow_error() {
  const bool shown = display().color == ColorBy::error;
  if (true_error.update(simulation, shown || follow_true_error) && shown) show_error();
}

void Session::measure_error() {
  true_error.measure(simulation);
  show_error();
}

void Session::show_error() {
  simulation.gpu()->set_vertex_errors(true_error.result()->distance);
  follow_largest(true_error.result()->largest);
}

void Session::follow_largest(double largest) {
  if (display().range || !look.heat_map) return;
  if (!(largest > 0) || !std::isfinite(largest)) return;
  // Grows at once, shrinks only when most of the range is unused: a bar that flickers cannot be read.
  if (largest > look.range.y() || largest < 0.2 * look.range.y())
    look.range = {0, static_cast<float>(round_up(largest))};
}

std::string Session::heat_label() const {
  switch (display().color) {
    case ColorBy::strain: return "Green strain, Frobenius norm [-]";
    case ColorBy::von_mises: return "von Mises stress [Pa]";
    case ColorBy::error: return "distance to the exact step [m]";
    case ColorBy::none: break;
  }
  return "";
}

void Session::draw(Framebuffer& framebuffer, const std::optional<GrabMark>& grab) {
  GpuSolver& solver = *simulation.gpu();
  solver.publish();
  framebuffer.bind();
  renderer_.draw(SurfaceView{&solver.positions()}, camera, look, grab, framebuffer);
  framebuffer.resolve();
}

}  // namespace fascia
