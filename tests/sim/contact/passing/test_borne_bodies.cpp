#include "sim/contact/passing/borne_bodies.h"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "sim/contact/pair_row.h"
#include "tests/sim/reference/box_model.h"
#include "tests/support/touching_bodies.h"

namespace fascia {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

// Two free cubes of 0.1 m beside each other, two plates below them, and a wall.
struct Cubes {
  Model model;
  ContactSurface contact;
  ContactMemory memory;
  ToolMotion motion;

  Cubes() {
    const Model cube = test::box_model(1, 1, 1, {0.1, 0.1, 0.1}, test::soft(1e5));
    model = test::beside(cube, test::moved(cube, {0.3, 0, 0}), "second");
    for (int k = 0; k < 3; ++k) {
      Tool plate;
      plate.shape = BoxShape{{0, 0, 0}, {0.1, 0.01, 0.1}};
      plate.path.emplace_back();
      model.tools.push_back(plate);
    }
    contact = make_contact_surface(model);
    memory.resize(contact.row_count);
    motion = motion_on_paths(model.tools, 0, 0);
  }
  // The tool presses the first point of the body.
  void press(std::size_t tool, std::size_t body) {
    const ContactPiece& piece = contact.pieces[tool];
    for (std::uint32_t p = 0; p < piece.points; ++p)
      if (contact.points[p].vertices[0] >= model.bodies[body].vertex_begin) {
        memory[piece.first_row + p].normal = 1;
        return;
      }
  }
  void move(std::size_t tool, const Eigen::Matrix3d& turn, const Vector3d& way) {
    motion.to[tool].pose.axes = turn * motion.from[tool].pose.axes;
    motion.to[tool].pose.origin = turn * motion.from[tool].pose.origin + way;
  }
  // The displacement of a body's first vertex after the motion; the others must have gone by the same rigid motion.
  Vector3d carried(std::size_t body, const Eigen::Matrix3d& turn = Eigen::Matrix3d::Identity()) {
    VectorXd u = VectorXd::Zero(static_cast<Eigen::Index>(3 * model.rest_positions.size()));
    BorneBodies(model, contact).carry(memory, u, motion);
    const BodyPart& part = model.bodies[body];
    const auto at = [&](std::size_t v) -> Vector3d {
      return model.rest_positions[v] + u.segment<3>(static_cast<Eigen::Index>(3 * v));
    };
    const std::size_t first = part.vertex_begin;
    const Vector3d moved = at(first) - model.rest_positions[first];
    const Eigen::Matrix3d way = moved.isZero(0) ? Eigen::Matrix3d(Eigen::Matrix3d::Identity()) : turn;
    for (std::size_t v = first; v < first + part.vertex_count; ++v)
      CHECK((at(v) - at(first) - way * (model.rest_positions[v] - model.rest_positions[first])).norm() < 1e-12);
    return moved;
  }
};

const Vector3d kUp(0, 0.2, 0);
const Eigen::Matrix3d kNone = Eigen::Matrix3d::Identity();

TEST_CASE("a body goes along with the tool that alone bears it, which then stands still", "[contact]") {
  Cubes cubes;
  cubes.press(0, 0);
  cubes.move(0, kNone, kUp);
  const ToolMotion before = cubes.motion;
  CHECK((cubes.carried(0) - kUp).norm() < 1e-12);
  CHECK(cubes.motion.from[0] == before.to[0]);
  CHECK(cubes.carried(1).isZero(0));
}

TEST_CASE("a body turns with the tool that bears it", "[contact]") {
  Cubes cubes;
  cubes.press(0, 0);
  const Eigen::Matrix3d turn(Eigen::AngleAxisd(0.7, Vector3d(1, 2, 0).normalized()));
  cubes.move(0, turn, kUp);
  const Vector3d first = cubes.model.rest_positions[0];
  CHECK((cubes.carried(0, turn) - (turn * first + kUp - first)).norm() < 1e-12);
}

TEST_CASE("a body that several tools press goes along only if all of them move alike", "[contact]") {
  Cubes cubes;
  cubes.press(0, 0);
  cubes.press(1, 0);
  cubes.move(0, kNone, kUp);
  CHECK(cubes.carried(0).isZero(0));
  CHECK(!(cubes.motion.from[0] == cubes.motion.to[0]));
  cubes.move(1, kNone, kUp);
  CHECK((cubes.carried(0) - kUp).norm() < 1e-12);
}

TEST_CASE("a tool that presses two bodies takes neither along, and one at rest none", "[contact]") {
  Cubes cubes;
  cubes.press(0, 0);
  CHECK(cubes.carried(0).isZero(0));
  cubes.press(0, 1);
  cubes.move(0, kNone, kUp);
  CHECK(cubes.carried(0).isZero(0));
  CHECK(cubes.carried(1).isZero(0));
}

TEST_CASE("what tissue presses does not go along", "[contact]") {
  const std::uint32_t slot = GENERATE(0u, 2u, 3u, 4u);
  Cubes cubes;
  cubes.press(0, 0);
  cubes.move(0, kNone, kUp);
  cubes.memory.resize(cubes.contact.row_count + memory_rows(5));
  CHECK((cubes.carried(0) - kUp).norm() < 1e-12);
  cubes.motion.from[0] = {};
  cubes.memory[cubes.contact.row_count + force_row(slot)].normal = 1;
  CHECK(cubes.carried(0).isZero(0));
}

}  // namespace
}  // namespace fascia
