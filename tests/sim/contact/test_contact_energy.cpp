#include "sim/contact/contact_energy.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "sim/contact/row_stiffness.h"
#include "tests/sim/contact/energy_derivatives.h"
#include "tests/sim/reference/box_model.h"

namespace fascia {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

struct Pressed {
  Model model = test::box_model(2, 2, 2, {0.2, 0.2, 0.2}, test::soft(1e5));
  ContactSurface surface;
  std::vector<double> stiffness, rows;
  ContactMemory memory;
  VectorXd start;
  ToolMotion motion;

  explicit Pressed(double friction) {
    SceneTools tools;
    tools.ground = Ground{0, friction};
    Instrument ball;
    ball.name = "ball";
    ball.shape = ToolShape(SphereShape{{0, 0, 0}, 0.05});
    ball.friction = friction;
    ball.path = {{0, {0.1, 0.23, 0.1}, {0, 0, 0}}, {1, {0.11, 0.22, 0.1}, {0, 0, 30}}};
    tools.instruments.push_back(ball);
    model.tools = tools_of(tools);
    surface = make_contact_surface(model);
    stiffness = contact_stiffness(model, surface);
    test::Random random(7);
    memory.resize(surface.row_count);
    for (ContactForce& force : memory) {
      force.normal = random() > 0.3 ? 5 * std::abs(random()) : 0;
      force.friction = 0.4 * force.normal * random.vector();
    }
    start = 1e-3 * random.vector(3 * static_cast<Eigen::Index>(model.rest_positions.size()));
    motion = motion_on_paths(model.tools, 0, 1);
    std::vector<Vector3d> u;
    for (Eigen::Index v = 0; v < start.size() / 3; ++v) u.push_back(start.segment<3>(3 * v));
    rows = row_stiffness(model, surface, stiffness, memory, motion, u, u);
  }
  ContactEnergy energy() const { return {model, surface, rows, memory, start, motion}; }
};

TEST_CASE("forces of contact are the gradient of its energy, and its blocks their derivative", "[contact]") {
  for (const double friction : {0.0, 0.5}) {
    const Pressed pressed(friction);
    const ContactEnergy energy = pressed.energy();
    test::Random random(8);
    const VectorXd u = pressed.start + 2e-3 * random.vector(pressed.start.size());
    CAPTURE(friction);
    test::check_derivatives(energy, energy.blocks(u, false), u);
  }
}

// What presses is out of the tool a stage later if k l^2 is 9 times what is held back.
TEST_CASE("the penalty of a short stage holds the mass at the point, and what a damper ties to it", "[contact]") {
  const double stiffness = 1e4, mass = 0.01;
  CHECK(stage_stiffness(stiffness, mass, 0, 0.001) == Approx(9 * mass / 1e-6));
  CHECK(stage_stiffness(stiffness, mass, 0, 0.003) == Approx(stiffness));
  CHECK(stage_stiffness(stiffness, mass, 0, 0.01) == stiffness);
  CHECK(stage_stiffness(stiffness, mass, 0, std::numeric_limits<double>::infinity()) == stiffness);
  // Held back is the root q of q^2 - y q - y t = 0, with the mass's own y = m / l^2 and the damper's t = d / l.
  const double length = 0.004, damping = 200, y = mass / (length * length), t = damping / length;
  const double held = stage_stiffness(stiffness, mass, damping, length) / 9;
  CHECK(held * held - y * held - y * t == Approx(0).margin(1e-9 * held * held));
  CHECK(stage_stiffness(stiffness, mass, damping, 0.04) == stiffness);
  const Pressed pressed(0.5);
  CHECK(stage_stiffness(pressed.model, pressed.surface, pressed.stiffness, 1.0 / 60) == pressed.stiffness);
  for (const double k : stage_stiffness(pressed.model, pressed.surface, pressed.stiffness, 1e-5))
    CHECK(k > *std::max_element(pressed.stiffness.begin(), pressed.stiffness.end()));
}

TEST_CASE("forces read out are opposite to those on the tissue, and friction keeps within its bound", "[contact]") {
  const Pressed pressed(0.5);
  const ContactEnergy energy = pressed.energy();
  const VectorXd u = 1.5 * pressed.start;
  VectorXd gradient = VectorXd::Zero(u.size());
  energy.evaluate(u, gradient);
  Vector3d on_tissue(0, 0, 0), torque(0, 0, 0), of_tools(0, 0, 0), torque_of_tools(0, 0, 0);
  for (std::size_t v = 0; v < pressed.model.rest_positions.size(); ++v) {
    const Vector3d force = -gradient.segment<3>(3 * static_cast<Eigen::Index>(v));
    on_tissue += force;
    torque += (pressed.model.rest_positions[v] + u.segment<3>(3 * static_cast<Eigen::Index>(v))).cross(force);
  }
  const std::vector<ToolLoad> loads = energy.loads(u);
  for (std::size_t t = 0; t < loads.size(); ++t) {
    of_tools += loads[t].force;
    torque_of_tools += loads[t].torque + pressed.motion.to[t].pose.origin.cross(loads[t].force);
  }
  CAPTURE(on_tissue.transpose(), of_tools.transpose(), torque.transpose(), torque_of_tools.transpose());
  CHECK((on_tissue - of_tools).norm() < 1e-12 * of_tools.norm());
  CHECK((torque - torque_of_tools).norm() < 1e-11 * of_tools.norm());
  for (const ContactForce& force : energy.memory_after(u)) {
    CHECK(force.normal >= 0);
    CHECK(force.friction.norm() <= 0.5 * force.normal + 1e-12);
  }
}

TEST_CASE("what the next stage starts with is the mean of the stages by their shares", "[contact]") {
  constexpr double kStiffness = 1e3;
  CHECK(kept_force(2, 5, 1, kStiffness) == 2);
  CHECK(kept_force(0, 5, 1, kStiffness) == 0);
  CHECK(kept_force(3, 1, 0.25, kStiffness) == Approx(1.5).epsilon(1e-15));
  CHECK(kept_force(0, 1, 0.25, kStiffness) == Approx(0.75).epsilon(1e-15));
  CHECK(kept_force(0, 1e-10, 0.25, kStiffness) == 0);

  // Forces that stages bear in turns: the impulse of friction is mu times the normal one.
  const double share = 1 - std::sqrt(0.5);  // of the second stage of SDIRK2
  double kept = 0, normal = 0, friction = 0;
  for (int step = 0; step < 100; ++step) {
    const double first = step < 50 ? 7 : 0, second = step % 10 == 9 ? 4 : 0;
    friction += (1 - share) * kept;
    kept = kept_force(first, kept, 1 - share, kStiffness);
    friction += share * kept;
    kept = kept_force(second, kept, share, kStiffness);
    normal += (1 - share) * first + share * second;
  }
  CAPTURE(normal, friction, kept);
  CHECK(friction + kept == Approx(normal).epsilon(1e-12));
}

}  // namespace
}  // namespace fascia
