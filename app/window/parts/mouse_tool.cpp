#include "app/window/parts/mouse_tool.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/overlay/grab_marks.h"
#include "app/state/deformed_positions.h"
#include "sim/visual/picking.h"

namespace fascia {
namespace {

constexpr double kDepthPerNotch = 0.04;            // of the wheel, in scene radii
constexpr double kPushPerNotch = 0.2;              // in patch radii
constexpr double kSmallest = 0.001, kLargest = 1;  // radius of a patch, in scene radii

// Position on the line from `center` along the unit vector `normal` that is closest to the ray of a place in the
// picture [m].
double along(const Eigen::Vector3d& center, const Eigen::Vector3d& normal, const Ray& ray) {
  const Eigen::Vector3d to_eye = ray.origin - center;
  const double cosine = ray.direction.dot(normal);
  constexpr double kLeastSine2 = 0.01;  // below it the ray is nearly parallel to the line, and no position is nearest
  return (to_eye.dot(normal) - to_eye.dot(ray.direction) * cosine) / std::max(1 - cosine * cosine, kLeastSine2);
}

void drag_section(const Eigen::Vector2d& from, const Eigen::Vector2d& to, MouseTool::Picture picture,
                  Session& session) {
  DisplaySettings display = session.display();
  if (!display.section) return;
  const Eigen::Vector3d normal = display.section->normal.normalized(), center = session.look.center;
  const Camera& camera = session.camera;
  // Cosine above which the normal has almost no direction in the picture: dragging upwards moves along it then
  constexpr double kHeadOn = 0.97;
  if (std::abs(camera.forward().dot(normal)) > kHeadOn) {
    display.section->offset += (from.y() - to.y()) * camera.pixel_size(center, picture.width, picture.height);
  } else {
    const auto place = [&](const Eigen::Vector2d& at) {
      return along(center, normal, camera.ray(at.x(), at.y(), picture.width, picture.height));
    };
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

std::optional<std::size_t> MouseTool::mark_at(const Eigen::Vector2d& at, Picture picture,
                                              const Session& session) const {
  const double reach = kMarkRadius * picture.height / 720.0;
  for (std::size_t i = grabs_.all().size(); i-- > 0;) {
    if (grabs_.follows(i)) continue;
    const auto pixel = pixel_of(session, grabs_.all()[i].grab.pointer(), picture.width, picture.height);
    if (pixel && (*pixel - at).norm() <= reach) return i;
  }
  return std::nullopt;
}

void MouseTool::press(Button button, Keys keys, const Eigen::Vector2d& at, Picture picture, Session& session,
                      const GrabSettings& settings) {
  if (dragging()) return;  // the first button determines the action
  button_ = button;
  last_ = at;
  if (const auto mark = mark_at(at, picture, session); mark && button != Button::middle) {
    if (button == Button::left) {
      grabs_.take_up(*mark);
      tool_ = Tool::grab;
    } else {
      grabs_.let_go(*mark);
      hold(session);
    }
    return;
  }
  tool_ = button == Button::left ? Tool::orbit : Tool::pan;
  if (button != Button::left || session.simulation.uses_reference()) return;

  const Ray ray = session.camera.ray(at.x(), at.y(), picture.width, picture.height);
  const std::vector<Eigen::Vector3d> positions = deformed_positions(session);
  const std::vector<Triangle>& triangles = session.surface().triangles;
  const auto hit = keys.shift ? pick_nearest(ray, triangles, positions, shown_cut(session.look))
                              : pick(ray, triangles, positions, shown_cut(session.look));
  GrabSettings how = settings;
  how.push = settings.push != keys.alt;
  if (!hit || !grabs_.take(session.simulation.model, session.surface(), positions, *hit, session.look.radius, how))
    return;
  tool_ = Tool::grab;
  if (keys.shift) move(at, picture, session);  // the mouse may be beside the tissue
}

void MouseTool::move(const Eigen::Vector2d& at, Picture picture, Session& session) {
  const Eigen::Vector2d from = last_, change = (at - from) / std::min(picture.width, picture.height);
  last_ = at;
  switch (tool_) {
    case Tool::none:
      break;
    case Tool::grab:
      if (Grab* grab = grabs_.following())
        grab->point_at(session.camera.ray(at.x(), at.y(), picture.width, picture.height), session.camera.forward());
      break;
    case Tool::orbit:
      session.camera.orbit(std::numbers::pi * change.x(), std::numbers::pi * change.y());
      break;
    case Tool::section:
      drag_section(from, at, picture, session);
      break;
    case Tool::pan:
      session.camera.pan(change.x(), change.y());
      break;
  }
}

void MouseTool::release(Button button, Keys keys, Session& session, const GrabSettings& settings) {
  if (button != button_) return;
  const bool grabbing = tool_ == Tool::grab;
  tool_ = Tool::none;
  if (!grabbing || !grabs_.following()) return;
  if (keys.control || settings.stay) {
    grabs_.stay();
  } else {
    grabs_.let_go_following();
    hold(session);
  }
}

bool MouseTool::scroll(double notches, Keys keys, Session& session, GrabSettings& settings) {
  if (keys.control) {
    resize(std::pow(1.1, notches), session, settings);
    return true;
  }
  Grab* grab = grabs_.following();
  if (!grab || tool_ != Tool::grab) return false;
  grab->go_deeper(
      notches * (grab->pushes() ? kPushPerNotch * grab->patch_radius() : kDepthPerNotch * session.look.radius),
      session.camera.forward());
  return true;
}

void MouseTool::resize(double factor, Session& session, GrabSettings& settings) {
  settings.radius = std::clamp(settings.radius * factor, kSmallest, kLargest);
  if (Grab* grab = grabs_.following()) grab->set_size(session.simulation.model, settings);
}

void MouseTool::stay() {
  if (tool_ != Tool::grab) return;
  grabs_.stay();
  tool_ = Tool::none;
}

void MouseTool::let_go(const Eigen::Vector2d& at, Picture picture, Session& session) {
  if (grabs_.empty()) return;
  std::size_t index = mark_at(at, picture, session).value_or(grabs_.all().size() - 1);
  if (grabs_.follows(index)) tool_ = Tool::none;
  grabs_.let_go(index);
  hold(session);
}

void MouseTool::let_go_staying(Session& session) {
  const std::size_t before = grabs_.all().size();
  for (std::size_t i = before; i-- > 0;)
    if (!grabs_.follows(i)) grabs_.let_go(i);
  if (grabs_.all().size() < before) hold(session);  // otherwise the grabs of a replay stay
}

void MouseTool::end_drag(Session& session) {
  tool_ = Tool::none;
  if (!grabs_.following()) return;
  grabs_.let_go_following();
  hold(session);
}

void MouseTool::cancel(Session& session) {
  tool_ = Tool::none;
  if (grabs_.empty()) return;
  grabs_.let_go_all();
  session.simulation.set_grab({});
}

void MouseTool::hold(Session& session) { session.simulation.set_grab(grabs_.springs(0)); }

void MouseTool::pull(Session& session) {
  if (!grabs_.empty()) session.simulation.set_grab(grabs_.springs(session.simulation.scene.solver.time_step));
}

}  // namespace fascia
