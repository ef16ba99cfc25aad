// The forces with which a scene begins, against the statics of rigid bodies.
#include "sim/contact/first_state.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>

#include "sim/contact/contact_surface.h"
#include "tests/sim/gpu/contact/contact_scenes.h"
#include "tests/support/touching_bodies.h"

namespace fascia {
namespace {

using Eigen::Vector3d;
using test::soft_tissue;

constexpr double kGravity = 9.81;

Model bar(const Vector3d& size, const Eigen::Vector3i& cells) {
  Model model = test::make_model(make_box(cells.x(), cells.y(), cells.z(), size), soft_tissue(1e5),
                                 [](const Vector3d&) { return false; });
  model.gravity = {0, -kGravity, 0};
  return model;
}

Tool ground(const Vector3d& normal = {0, 1, 0}, double height = 0) {
  return test::tool("ground", PlaneShape{{0, height, 0}, normal}, 0.5);
}

double weight_of(const Model& model) {
  const std::vector<double> masses = consistent_masses(model);
  return kGravity * std::accumulate(masses.begin(), masses.end(), 0.0);
}

/// [tool] sums of the normal forces.
std::vector<double> sums(const Model& model) {
  const State state = first_state(model);
  std::vector<double> sums(model.tools.size(), 0);
  if (state.contact.empty()) return sums;
  for (const ContactPiece& piece : make_contact_surface(model).pieces)
    for (std::size_t p = 0; p < piece.points; ++p) {
      const ContactForce& force = state.contact[piece.first_row + p];
      CHECK(force.normal >= 0);
      CHECK(force.friction.isZero(0));
      sums[piece.tool] += force.normal;
    }
  return sums;
}

TEST_CASE("a body that begins on the ground begins with its weight", "[contact]") {
  Model model = bar({0.1, 0.1, 0.1}, {3, 3, 3});
  const double slope = GENERATE(0.0, 0.3);
  const Vector3d normal(std::sin(slope), std::cos(slope), 0);
  model.tools = {ground(normal)};
  for (Vector3d& x : model.rest_positions) x = Eigen::AngleAxisd(-slope, Vector3d::UnitZ()) * x;
  const double sum = sums(model)[0];
  CAPTURE(slope, sum, weight_of(model));
  CHECK(sum == Approx(weight_of(model) * std::cos(slope)).epsilon(1e-5));
}

// A bar on two supports, a narrow box under each end: forces as lever arms say. Its middle is 0.15 m from its left end.
TEST_CASE("supports share a weight by their lever arms", "[contact]") {
  Model model = bar({0.3, 0.05, 0.05}, {30, 2, 2});
  model.tools = {test::tool("left", BoxShape{{0.02, -0.02, 0.025}, {0.011, 0.02, 0.05}, 0}, 0.5),
                 test::tool("right", BoxShape{{0.22, -0.02, 0.025}, {0.011, 0.02, 0.05}, 0}, 0.5)};
  const std::vector<double> found = sums(model);
  const double weight = weight_of(model), right = weight * 0.13 / 0.2;
  CAPTURE(found[0], found[1], weight);
  CHECK(found[0] + found[1] == Approx(weight).epsilon(1e-5));
  // Each of the supports is three points wide, which a bar that turns presses by different forces.
  CHECK(found[1] == Approx(right).epsilon(0.02));
}

TEST_CASE("a body of two that lies on the ground begins with its own weight", "[contact]") {
  const Model lying = bar({0.1, 0.1, 0.1}, {2, 2, 2});
  Model model = test::beside(lying, test::moved(bar({0.2, 0.1, 0.1}, {2, 2, 2}), {0, 0.3, 0}, {0, 0, 0}), "above");
  model.gravity = lying.gravity;
  model.tools = {ground()};
  CHECK(sums(model)[0] == Approx(weight_of(lying)).epsilon(1e-5));
}

TEST_CASE("what does not lie on a tool begins without forces", "[contact]") {
  Model model = bar({0.1, 0.1, 0.1}, {2, 2, 2});
  model.tools = {ground()};
  const double edge = 0.05;  // of the cells
  SECTION("above it") { model.tools = {ground({0, 1, 0}, -0.01 * edge)}; }
  SECTION("inside it") { model.tools = {ground({0, 1, 0}, 0.01 * edge)}; }
  SECTION("leaving it") { model.initial_velocity.assign(model.rest_positions.size(), {1, 0.01, 0}); }
  SECTION("held") { model.fixed = {0}; }
  SECTION("weightless") { model.gravity.setZero(); }
  SECTION("beside it") { model.tools = {ground({1, 0, 0})}; }
  for (const double sum : sums(model)) CHECK(sum <= 1e-5 * weight_of(model));
}

TEST_CASE("a body that slides on the ground at the start begins with its weight", "[contact]") {
  Model model = bar({0.1, 0.1, 0.1}, {2, 2, 2});
  model.tools = {ground()};
  model.initial_velocity.assign(model.rest_positions.size(), {1, 0, 0.3});
  CHECK(sums(model)[0] == Approx(weight_of(model)).epsilon(1e-5));
}

// From E A times the strain, where sides bulge freely, to (lambda + 2 mu) / E = 3.8 times as much, where they do not.
TEST_CASE("a body that two tools squeeze begins with forces of about its stiffness, the same from both sides",
          "[contact]") {
  const double size = 0.04, squeeze = GENERATE(0.001, 0.0005);
  Model model = bar({size, size, size}, {4, 4, 4});
  const BoxShape plate{{0, 0, 0}, {0.01, 0.06, 0.06}, 0};
  for (const double side : {-1.0, 1.0}) {
    Tool tool = test::tool(side < 0 ? "left" : "right", plate, 0.5);
    tool.path[0].position = {size / 2 + side * (size / 2 + 0.01 - squeeze), size / 2, size / 2};
    model.tools.push_back(tool);
  }
  if (GENERATE(false, true)) model.gravity.setZero();
  const double uniaxial = 1e5 * size * size * 2 * squeeze / size;
  const std::vector<double> found = sums(model);
  CAPTURE(found[0], found[1], uniaxial);
  CHECK(found[0] == Approx(found[1]).epsilon(1e-3));
  CHECK(found[0] > uniaxial);
  CHECK(found[0] < 3.8 * uniaxial);
  model.tools.pop_back();
  CHECK(sums(model)[0] <= 1e-5 * found[0]);
}

}  // namespace
}  // namespace fascia
