// The beam of the figures: its free end, and its bent and twisted start.
#include "app/bench/beam.h"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>

#include "app/bench/box.h"
#include "sim/reference/newton.h"

using namespace fascia;
using Eigen::Vector3d;

TEST_CASE("the tip is the free end") {
  const Model model = box_model({8, 2, 2});
  const std::vector<std::uint32_t> tip = beam_tip(model);
  CHECK(tip.size() == 9);
  for (const std::uint32_t v : tip) CHECK(model.rest_positions[v].x() == 1);
}

TEST_CASE("the start is bent and twisted by known angles, keeps the held vertices, and inverts no tet") {
  const Model model = box_model({24, 6, 6});
  const State state = bent_beam(model);
  for (const std::uint32_t v : model.fixed) CHECK(state.displacement[v].norm() == 0);
  const reference::Measures measures = reference::measure(model, state);
  CAPTURE(measures.rms_strain, measures.min_det_f);
  CHECK(measures.inverted == 0);
  CHECK(measures.rms_strain > 0.05);
  CHECK(measures.rms_strain < 0.2);
  // Cross sections turn as rigid plates: about z and about their own normal by 0.85 each at the tip.
  std::vector<Vector3d> rest, now;
  for (const std::uint32_t v : beam_tip(model)) {
    rest.push_back(model.rest_positions[v]);
    now.push_back(model.rest_positions[v] + state.displacement[v]);
  }
  const Eigen::Matrix3d turn =
      (Eigen::AngleAxisd(0.85, Vector3d::UnitZ()) * Eigen::AngleAxisd(0.85, Vector3d::UnitX())).toRotationMatrix();
  for (std::size_t k = 1; k < rest.size(); ++k) {
    CAPTURE(k);
    CHECK((now[k] - now[0] - turn * (rest[k] - rest[0])).norm() < 1e-6);
  }
  for (const Vector3d& u : state.displacement) CHECK(u == float32_of(u));  // exactly representable in float32
}

TEST_CASE("the squared distance is summed over vertices") {
  CHECK(squared_distance({{0, 0, 0}, {1, 2, 3}}, {{1, 0, 0}, {1, 0, 1}}) == 9);
  CHECK(squared_distance({}, {}) == 0);
}
