// Covers: contact_block
#include "sim/contact/pair_energy.h"

#include <catch2/catch.hpp>

#include "tests/sim/contact/energy_derivatives.h"
#include "tests/sim/reference/box_model.h"
#include "tests/support/touching_bodies.h"

namespace fascia {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

struct Touching {
  Model model = test::beside(test::box_model(1, 1, 1, {0.1, 0.1, 0.1}, test::soft(1e5)),
                             test::box_model(1, 1, 1, {0.1, 0.1, 0.1}, test::soft(1e5)), "second");
  std::vector<PairRow> rows;
  ContactMemory memory;
  VectorXd start;

  explicit Touching(double friction) {
    model.contact.friction = friction;
    test::Random random(5);
    start = 1e-3 * random.vector(3 * static_cast<Eigen::Index>(model.rest_positions.size()));
    const std::array<std::array<double, 4>, 2> weights{{{1, -0.2, -0.3, -0.5}, {0.4, 0.6, 0.2, -1.2}}};
    for (std::uint32_t k = 0; k < 6; ++k) {
      PairRow& row = rows.emplace_back();
      row.vertices = k % 2 ? std::array<std::uint32_t, 4>{k, k + 1, 8 + k, 9 + k}
                           : std::array<std::uint32_t, 4>{k, 8 + k, 9 + k, 10 + k};
      row.weights = weights[k % 2];
      row.sides = k % 2 ? PairRow::kOfEdges : PairRow::kOfVertex;
      row.normal = random.vector().normalized();
      for (std::size_t a = 0; a < 4; ++a)
        row.start += row.weights[a] * start.segment<3>(3 * static_cast<Eigen::Index>(row.vertices[a]));
      row.gap = 1e-3 * random();
      row.stiffness = 1e3 * (1.5 + random());
      row.slot = k;
      row.met = 10 + k;
      row.bodies = {0, 1};
    }
    memory.resize(memory_rows(6));
    for (std::uint32_t k = 0; k < 6; ++k) {
      ContactForce& force = memory[force_row(k)];
      force.normal = random() > 0 ? 3 * std::abs(random()) : 0;
      force.friction = 0.5 * force.normal * random.vector();
    }
  }
};

TEST_CASE("forces between tissue are the gradient of their energy, and the blocks their derivative", "[contact]") {
  for (const double friction : {0.0, 0.5}) {
    const Touching touching(friction);
    const PairEnergy energy(touching.model, touching.rows, touching.memory, 0);
    test::Random random(8);
    const VectorXd u = touching.start + 2e-3 * random.vector(touching.start.size());
    CAPTURE(friction);
    test::check_derivatives(energy, energy.blocks(u), u);
  }
}

TEST_CASE("bodies as wholes feel all pairs between them, also those beside the end of an edge", "[contact]") {
  const Touching touching(0.5);
  const PairEnergy energy(touching.model, touching.rows, touching.memory, 0);
  test::Random random(8);
  const VectorXd u = touching.start + 2e-3 * random.vector(touching.start.size());
  VectorXd gradient = VectorXd::Zero(u.size());
  energy.evaluate(u, gradient);
  std::vector<std::uint32_t> bodies(touching.model.rest_positions.size(), 0);
  std::fill(bodies.begin() + 8, bodies.end(), 1);
  std::vector<BodyContact> contacts;
  energy.append_to(contacts, bodies, u);
  REQUIRE(contacts.size() == touching.rows.size());
  for (const std::uint32_t body : {0u, 1u}) {
    Vector3d force(0, 0, 0), torque(0, 0, 0), expected(0, 0, 0), expected_torque(0, 0, 0);
    for (const BodyContact& c : contacts) {
      const Vector3d pressing = std::max(0.0, c.before + c.stiffness * c.depth) * c.normal;
      const Vector3d of_pair = (c.bodies[0] == body ? 1 : -1) * (pressing + within(c.tangential, c.bound));
      force += of_pair;
      torque += c.places[c.bodies[0] == body ? 0 : 1].cross(of_pair);
    }
    for (std::size_t v = 0; v < bodies.size(); ++v) {
      if (bodies[v] != body) continue;
      const Vector3d of_vertex = -gradient.segment<3>(3 * static_cast<Eigen::Index>(v));
      expected += of_vertex;
      expected_torque +=
          (touching.model.rest_positions[v] + u.segment<3>(3 * static_cast<Eigen::Index>(v))).cross(of_vertex);
    }
    CAPTURE(body, force, expected, torque, expected_torque);
    CHECK((force - expected).norm() < 1e-12 * expected.norm());
    CHECK((torque - expected_torque).norm() < 1e-12 * expected_torque.norm());
  }
}

TEST_CASE("forces between tissue add up to nothing, and the load of a body is their sum", "[contact]") {
  const Touching touching(0.5);
  const PairEnergy energy(touching.model, touching.rows, touching.memory, 0);
  const VectorXd u = 1.5 * touching.start;
  VectorXd gradient = VectorXd::Zero(u.size());
  energy.evaluate(u, gradient);
  Vector3d first(0, 0, 0), second(0, 0, 0);
  for (Eigen::Index v = 0; v < 16; ++v) (v < 8 ? first : second) -= gradient.segment<3>(3 * v);
  const std::vector<PairLoad> loads = energy.loads(u);
  REQUIRE(loads.size() == 1);
  CAPTURE(first.transpose(), second.transpose(), loads[0].force.transpose(), loads[0].pairs);
  CHECK(second.norm() > 0.1);
  CHECK((first + second).norm() < 1e-12 * second.norm());
  CHECK((loads[0].force - second).norm() < 1e-12 * second.norm());
  CHECK(loads[0].bodies == std::array<std::uint32_t, 2>{0, 1});
  ContactMemory memory(memory_rows(6));
  energy.remember(u, 1, memory);
  double normal = 0;
  for (std::uint32_t k = 0; k < 6; ++k) {
    const ContactForce& force = memory[force_row(k)];
    CHECK(force.normal >= 0);
    CHECK(force.friction.norm() <= 0.5 * force.normal + 1e-12);
    CHECK(met_in(memory[met_row(k)], k) == 10 + k);
    normal += force.normal;
  }
  CHECK(loads[0].normal == Approx(normal));
  CHECK(load_between(loads, {0, 1}).force == loads[0].force);
  CHECK(load_between(loads, {1, 1}).pairs == 0);
}

TEST_CASE("bodies may touch each other, themselves, or nothing", "[contact]") {
  using Bodies = std::vector<std::array<std::uint32_t, 2>>;
  Model model = Touching(0.5).model;
  CHECK(touching_bodies(model) == Bodies{{0, 1}});
  model.contact.self = true;
  CHECK(touching_bodies(model) == Bodies{{0, 0}, {0, 1}, {1, 1}});
  model.contact.bodies = model.contact.self = false;
  CHECK(touching_bodies(model).empty());
}

TEST_CASE("a memory without slots means no forces", "[contact]") {
  const Touching touching(0.5);
  const PairEnergy fresh(touching.model, touching.rows, {}, 0),
      zeros(touching.model, touching.rows, ContactMemory(memory_rows(6)), 0);
  VectorXd a = VectorXd::Zero(touching.start.size()), b = a;
  CHECK(fresh.evaluate(touching.start, a) == zeros.evaluate(touching.start, b));
  CHECK(a == b);
}

}  // namespace
}  // namespace fascia
