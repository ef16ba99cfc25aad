#include "sim/contact/step_loads.h"

#include <catch2/catch.hpp>

namespace fascia {
namespace {

using Eigen::Vector3d;

}  // namespace

TEST_CASE("the mean of loads has the shares of all stages", "[contact]") {
  StepLoads step;
  const auto tool = [](double force, std::uint32_t points) {
    return ToolLoad{Vector3d(force, 0, 0), Vector3d(0, force, 0), 2 * force, points, 1e-3 * points};
  };
  const auto pair = [](std::uint32_t a, std::uint32_t b, double force) {
    return PairLoad{{a, b}, Vector3d(0, 0, force), force, 2, 1e-3};
  };
  const ContactLoads alone = step.mean({{tool(3, 5)}, {pair(0, 1, 7)}});
  CHECK(alone.tools[0].force.x() == 3);
  CHECK(alone.pairs[0].normal == 7);
  step.add(0.75, {{tool(4, 9)}, {pair(1, 2, 8)}});
  const ContactLoads mean = step.mean({{tool(8, 5)}, {pair(0, 1, 12)}});
  CHECK(mean.tools[0].force.x() == Approx(5));
  CHECK(mean.tools[0].torque.y() == Approx(5));
  CHECK(mean.tools[0].normal == Approx(10));
  CHECK(mean.tools[0].points == 5);
  CHECK(mean.tools[0].deepest == Approx(5e-3));
  REQUIRE(mean.pairs.size() == 2);
  CHECK(load_between(mean.pairs, {0, 1}).force.z() == Approx(3));
  CHECK(load_between(mean.pairs, {0, 1}).pairs == 2);
  CHECK(load_between(mean.pairs, {1, 2}).normal == Approx(6));
  CHECK(load_between(mean.pairs, {1, 2}).pairs == 0);  // parted by the end of the step
  step.begin();
  CHECK(step.mean({{tool(8, 5)}, {}}).tools[0].force.x() == 8);
}

}  // namespace fascia
