#include "app/mouse_tool.h"

#include <cmath>
#include <numbers>

#include "app/pick.h"
#include "shaders/shared/types.h"

namespace fascia {
namespace {

// One readback, at the moment of the press only.
std::vector<Eigen::Vector3d> deformed_positions(Session& session) {
  GpuSolver& solver = *session.simulation.gpu();
  solver.publish();
  std::vector<Eigen::Vector3d> positions;
  for (const shared::vec4& p : solver.positions().read<shared::vec4>()) positions.emplace_back(p.x, p.y, p.z);
  return positions;
}

// Where the line from `center` along the unit vector `normal` comes closest to what is seen at a place of the picture [m].
double along(const Eigen::Vector3d& center, const Eigen::Vector3d& normal, const Ray& ray) {
  const Eigen::Vector3d to_eye = ray.origin - center;
  const double cosine = ray.direction.dot(normal);
  return (to_eye.dot(normal) - to_eye.dot(ray.direction) * cosine) / (1 - cosine * cosine);
}

void drag_section(const Eigen::Vector2d& from, const Eigen::Vector2d& to, MouseTool::Picture picture, Session& session) {
  DisplaySettings display = session.display();
  if (!display.section) return;
  const Eigen::Vector3d normal = display.section->normal.normalized(), center = session.look.center;
  const Camera& camera = session.camera;
  constexpr double kHeadOn = 0.97;  // cosine beyond which the normal has no direction in the picture to speak of: up is along it then
  if (std::abs(camera.forward().dot(normal)) > kHeadOn) {
    display.section->offset += (from.y() - to.y()) * camera.pixel_size(center, picture.height);
  } else {
    const auto place = [&](const Eigen::Vector2d& at) { return along(center, normal, camera.ray(at.x(), at.y(), picture.width, picture.height)); };
    display.section->offset += place(to) - place(from);
  }
  session.set_display(display);
}

}  // namespace

void MouseTool::press_section(Button button, const Eigen::Vector2d& at) {
  if (dragging()) return;
  button_ = button;
  last_ = at;
  tool_ = Tool::section;
}

void MouseTool::press(Button button, bool always_grab, const Eigen::Vector2d& at, Picture picture, Session& session,
                      const GrabSettings& settings) {
  if (dragging()) return;  // the first button decides
  button_ = button;
  last_ = at;
  tool_ = button == Button::left ? Tool::orbit : Tool::pan;
  if (button != Button::left || session.simulation.uses_reference()) return;

  const Ray ray = session.camera.ray(at.x(), at.y(), picture.width, picture.height);
  const std::vector<Eigen::Vector3d> positions = deformed_positions(session);
  const std::vector<Triangle>& triangles = session.surface().triangles;
  const auto hit = always_grab ? pick_nearest(ray, triangles, positions) : pick(ray, triangles, positions);
  if (!hit || !grab_.take(session.simulation.model, positions, triangles[hit->triangle], *hit, session.look.radius, settings)) return;
  tool_ = Tool::grab;
  session.set_grabbed(grab_.vertices());
  if (always_grab) move(at, picture, session);  // the mouse may be beside the tissue
}

void MouseTool::move(const Eigen::Vector2d& at, Picture picture, Session& session) {
  const Eigen::Vector2d from = last_, change = (at - from) / picture.height;
  last_ = at;
  switch (tool_) {
    case Tool::none: break;
    case Tool::grab:
      grab_.point_at(session.camera.ray(at.x(), at.y(), picture.width, picture.height), session.camera.forward());
      break;
    case Tool::orbit: session.camera.orbit(std::numbers::pi * change.x(), std::numbers::pi * change.y()); break;
    case Tool::section: drag_section(from, at, picture, session); break;
    case Tool::pan: session.camera.pan(change.x(), change.y()); break;
  }
}

void MouseTool::release(Button button, Session& session) {
  if (button == button_) cancel(session);
}

void MouseTool::cancel(Session& session) {
  tool_ = Tool::none;
  if (!grab_.holding()) return;
  grab_.release();
  session.set_grabbed({});
  session.simulation.set_grab({});
}

void MouseTool::pull(Session& session) {
  if (grab_.holding()) session.simulation.set_grab(grab_.springs(session.simulation.scene.solver.time_step));
}

}  // namespace fascia
