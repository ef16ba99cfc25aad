#include <catch2/catch.hpp>

#include "sim/fit/measured/shape_distance.h"
#include "sim/model/state.h"
#include "tests/support/models.h"

namespace fascia {

using Eigen::Vector3d;

TEST_CASE("the distance to a measured shape", "[fit]") {
  const bool curved = GENERATE(false, true);
  Model model = test::make_model(make_box(2, 2, 2, {0.2, 0.2, 0.2}), {}, [](const Vector3d&) { return false; });
  if (curved) model = test::quadratic(model);
  std::vector<Vector3d> moved(model.rest_positions.size(), Vector3d(0.01, 0, 0));

  MeasuredShape vertices{{0, 3}, {model.rest_positions[0], model.rest_positions[3] + Vector3d(0, 0.02, 0)}, 0};
  const std::vector<double> components = distances_to(vertices, model, moved);
  const std::vector<double> expected{0.01, 0, 0, 0.01, -0.02, 0};
  REQUIRE(components.size() == 6);
  for (std::size_t i = 0; i < 6; ++i) CHECK(components[i] == Approx(expected[i]).margin(1e-15));

  // Outside of the face x = 0.21, inside of it, and off an edge.
  MeasuredShape points{{}, {{0.23, 0.1, 0.1}, {0.2, 0.1, 0.1}, {0.24, 0.24, 0.1}}, 0};
  const std::vector<double> distances = distances_to(points, model, moved);
  REQUIRE(distances.size() == 3);
  CHECK(distances[0] == Approx(0.02));
  CHECK(distances[1] == Approx(-0.01));
  CHECK(distances[2] == Approx(std::hypot(0.03, 0.04)));
}

}  // namespace fascia
