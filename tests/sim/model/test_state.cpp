// The initial state of a model.
#include "sim/model/state.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/models.h"

using namespace fascia;
using Eigen::Vector3d;

TEST_CASE("a model starts at rest, with its initial velocities, at time 0") {
  Model model = test::make_model(make_box(2, 1, 1, {1, 1, 1}), Material{}, [](const Vector3d&) { return false; });
  for (std::size_t v = 0; v < model.initial_velocity.size(); ++v)
    model.initial_velocity[v] = Vector3d(static_cast<double>(v), -1, 0.5);
  const State state = initial_state(model);
  CHECK(state.time == 0);
  CHECK(state.velocity == model.initial_velocity);
  CHECK(state.displacement == std::vector<Vector3d>(12, Vector3d(0, 0, 0)));
}

TEST_CASE("a vertex that no tet has is at rest, whatever the velocity of its body") {
  TetMesh mesh = make_box(2, 1, 1, {1, 1, 1});
  mesh.positions.insert(mesh.positions.begin(), {0.5, 0.5, 0.5});
  for (Tet& tet : mesh.tets)
    for (std::uint32_t& v : tet) ++v;
  Model model = test::make_model(mesh, Material{}, [](const Vector3d&) { return false; });
  model.initial_velocity.assign(mesh.positions.size(), Vector3d(1, 2, -0.5));
  const State state = initial_state(model);
  CHECK(state.velocity[0] == Vector3d(0, 0, 0));
  CHECK(state.velocity[1] == Vector3d(1, 2, -0.5));
}

TEST_CASE("a state is finite if every displacement and every velocity is") {
  const Model model = test::make_model(make_box(2, 1, 1, {1, 1, 1}), Material{}, [](const Vector3d&) { return false; });
  const State good = initial_state(model);
  CHECK(is_finite(good));
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    State displaced = good, fast = good;
    displaced.displacement.back().z() = bad;
    fast.velocity.front().x() = bad;
    CHECK_FALSE(is_finite(displaced));
    CHECK_FALSE(is_finite(fast));
  }
}

TEST_CASE("float32_of rounds every component to the nearest float32") {
  for (const double x : {1.0 / 3, -0.24342000000000001, 1e-3 * 0.7, 12345.678901}) {
    const Eigen::Vector3d v(x, 2.1 * x, -x / 7), rounded = float32_of(v);
    for (int k = 0; k < 3; ++k) {
      const volatile float stored = static_cast<float>(v[k]);
      CAPTURE(x, k, rounded[k] - v[k]);
      CHECK(rounded[k] == static_cast<double>(stored));
      CHECK(rounded[k] != v[k]);
    }
  }
}
