#include "app/window/parts/instrument_hand.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>

#include "app/state/deformed_positions.h"
#include "sim/contact/tissue/kept_back.h"
#include "sim/tool/followed_place.h"
#include "sim/visual/picking.h"
#include "sim/visual/tool_picking.h"

namespace fascia {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kAwayPerNotch = 0.01;  // of the wheel, in scene radii
constexpr double kClosing = 2;          // [s] from open to closed

std::size_t first_instrument(const Simulation& simulation) {
  return simulation.model.tools.size() - simulation.scene.tools.instruments.size();
}

Vector3d on_plane(const Camera& camera, const Vector2d& at, InstrumentHand::Picture picture, const Vector3d& through) {
  const Ray ray = camera.ray(at.x(), at.y(), picture.width, picture.height);
  const Vector3d normal = camera.forward();
  return ray.origin + ray.direction * (through - ray.origin).dot(normal) / ray.direction.dot(normal);
}

}  // namespace

void InstrumentHand::pick(std::optional<std::size_t> tool) {
  if (tool != picked_) rest();
  picked_ = tool;
}

void InstrumentHand::pick_next(const Simulation& simulation) {
  const std::size_t next = picked_ ? *picked_ + 1 : first_instrument(simulation);
  pick(next < simulation.model.tools.size() ? std::optional(next) : std::nullopt);
}

std::optional<std::size_t> InstrumentHand::at(const Vector2d& pixel, Picture picture, Session& session) {
  const Simulation& simulation = session.simulation;
  if (simulation.scene.tools.instruments.empty()) return std::nullopt;
  const Ray ray = session.camera.ray(pixel.x(), pixel.y(), picture.width, picture.height);
  const auto hit = pick_tool(ray, simulation.model.tools, simulation.tool_places(), first_instrument(simulation));
  if (!hit) return std::nullopt;
  const auto tissue =
      fascia::pick(ray, session.surface().triangles, deformed_positions(session), shown_cut(session.look));
  const bool hidden = tissue && (tissue->point - ray.origin).norm() < hit->distance;
  return hidden ? std::nullopt : std::optional(hit->tool);
}

void InstrumentHand::press(Drag drag, const Vector2d& at) {
  if (dragging() || !picked_) return;
  drag_ = drag;
  last_ = at;
}

LedPlace& InstrumentHand::command(const Session& session) {
  if (!commanded_) commanded_ = led_place(session.simulation.tool_places()[*picked_]);
  return *commanded_;
}

void InstrumentHand::move(const Vector2d& at, Picture picture, const Session& session) {
  if (!dragging()) return;
  const Camera& camera = session.camera;
  LedPlace& place = command(session);
  if (drag_ == Drag::shift) {
    const Vector3d through = place.position;
    place.position += on_plane(camera, at, picture, through) - on_plane(camera, last_, picture, through);
  } else {
    const Vector2d angle = std::numbers::pi * (at - last_) / std::min(picture.width, picture.height);
    const Matrix3d axes = camera.view().topLeftCorner<3, 3>().cast<double>();
    const auto about = [&](int axis, double by) {
      return Eigen::AngleAxisd(by, axes.row(axis).transpose().normalized()).toRotationMatrix();
    };
    ToolPlace turned = place.place();
    turned.pose.axes = about(1, angle.x()) * about(0, angle.y()) * turned.pose.axes;
    place = led_place(turned);
  }
  last_ = at;
}

void InstrumentHand::scroll(double notches, const Session& session) {
  command(session).position += notches * kAwayPerNotch * session.look.radius * session.camera.forward();
}

void InstrumentHand::move_jaws(double grip, const Session& session) {
  if (!picked_ || !session.simulation.model.tools[*picked_].has_jaws) return;
  command(session);
  grip_ = grip;
}

// Near tissue the jaws are behind the command: they stop where they are.
void InstrumentHand::stop_jaws(const Session& session) {
  if (!grip_) return;
  grip_.reset();
  command(session).grip = session.simulation.tool_places()[*picked_].grip;
}

void InstrumentHand::lead(Session& session) {
  waits_ = false;
  if (!picked_ || !commanded_) return;
  Simulation& simulation = session.simulation;
  const Tool& tool = simulation.model.tools[*picked_];
  if (grip_) {
    const double most = simulation.scene.solver.time_step / kClosing;
    commanded_->grip += std::clamp(*grip_ - commanded_->grip, -most, most);
  }
  const ToolPlace now = simulation.tool_places()[*picked_], wanted = commanded_->place();
  if (now == wanted) return simulation.lead({tool.name, *commanded_});
  if (!cover_) cover_ = std::make_unique<TissueCover>(simulation.model, followed_radius(tool, 2 * session.look.radius));
  const std::vector<Vector3d> positions = deformed_positions(session);
  cover_->follow(positions);
  const ToolPlace followed = followed_place(tool, now, wanted, cover_->size(),
                                            [&](const ToolPlace& place) { return cover_->clearance(tool, place); });
  const double near = followed_radius(tool, cover_->size());
  const ToolPlace next = cover_->clearance(tool, followed) < near
                             ? kept_back(simulation.model, positions, tool, now, followed, near)
                             : followed;
  waits_ = !(next == followed);
  if (next == now) return stay(simulation, now);
  simulation.lead({tool.name, next == wanted ? *commanded_ : led_place(next)});
}

// Off its path, at the place in the numbers that it has already.
void InstrumentHand::stay(Simulation& simulation, const ToolPlace& now) {
  const std::string& name = simulation.model.tools[*picked_].name;
  for (const LedTool& led : simulation.led_tools())
    if (led.name == name) return;
  simulation.lead({name, led_place(now)});
}

void InstrumentHand::rest() {
  commanded_.reset();
  waits_ = false;
  grip_.reset();
  drag_ = Drag::none;
  cover_.reset();
}

std::optional<ToolPlace> InstrumentHand::commanded() const {
  return commanded_ ? std::optional(commanded_->place()) : std::nullopt;
}

double InstrumentHand::gap(const Session& session) const {
  if (!picked_ || !commanded_) return 0;
  const Simulation& simulation = session.simulation;
  constexpr double kRounding = 1e-12;  // of turned axes, in sizes of the scene
  const double gap = way_between(simulation.model.tools[*picked_], simulation.tool_places()[*picked_],
                                 commanded_->place(), 2 * session.look.radius);
  return gap > kRounding * session.look.radius ? gap : 0;
}

}  // namespace fascia
