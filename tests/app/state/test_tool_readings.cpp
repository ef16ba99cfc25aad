// Means of forces over the last readings.
#include "app/state/tool_readings.h"

#include <catch2/catch.hpp>

using namespace fascia;
using Eigen::Vector3d;

namespace {

std::vector<ToolLoad> load(double newtons, std::uint32_t points) {
  return {ToolLoad{{newtons, 0, 0}, {0, 2 * newtons, 0}, 3 * newtons, points, 1e-3 * points}};
}

}  // namespace

TEST_CASE("readings are averaged over the last five, with points and depth of the last one") {
  ToolReadings readings;
  CHECK(readings.mean().empty());
  for (int i = 1; i <= 7; ++i) readings.add(i, load(i, static_cast<std::uint32_t>(i)));
  const ToolLoad mean = readings.mean().front();
  CHECK(mean.force.x() == Approx(5));  // of 3 to 7
  CHECK(mean.torque.y() == Approx(10));
  CHECK(mean.normal == Approx(15));
  CHECK(mean.points == 7);
  CHECK(mean.deepest == 7e-3);

  readings.add(7, load(12, 1));  // another reading of the same step
  CHECK(readings.mean().front().force.x() == Approx(6));
  readings.add(1, load(1, 1));  // after a reset
  CHECK(readings.mean().front().force.x() == 1);
}
