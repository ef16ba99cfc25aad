// The plane that stands for a tool where the way of a point leads through it or too deep into it.
#include "sim/tool/tool_entry.h"

#include <catch2/catch.hpp>

namespace fascia {
namespace {

using Eigen::Vector3d;

TEST_CASE("a point that would go through a box meets the side that it enters by", "[tool]") {
  const ToolShape table = BoxShape{{0, -0.05, 0}, {0.5, 0.05, 0.5}};
  for (const double end : {-0.06, -0.09, -0.3}) {
    const auto entry = entry_into(table, {0.1, 0.02, 0}, {0.1, end, 0}, {0.1, 0.02, 0}, 0);
    CAPTURE(end);
    REQUIRE(entry);
    CHECK(entry->normal.y() == Approx(1));
    CHECK(entry->offset == Approx(0).margin(1e-12));
  }
  // With a skin around it the same plane, since the skin is subtracted from its distance.
  CHECK(entry_into(table, {0.1, 0.02, 0}, {0.1, -0.3, 0}, {0.1, 0.02, 0}, 0.004)->offset == Approx(0).margin(1e-12));
  CHECK(entry_into(table, {0.1, 0, 0}, {0.1, -0.3, 0}, {0.1, 0, 0}, 0)->normal.y() == Approx(1));
}

TEST_CASE("the distance to the shape serves where the side by which a point enters is the nearest", "[tool]") {
  const ToolShape table = BoxShape{{0, -0.05, 0}, {0.5, 0.05, 0.5}};
  CHECK_FALSE(entry_into(table, {0.1, 0.02, 0}, {0.1, -0.03, 0}, {0.1, 0.02, 0}, 0));
  CHECK_FALSE(entry_into(table, {0.1, 0.3, 0}, {0.1, 0.02, 0}, {0.1, 0.3, 0}, 0));
  CHECK_FALSE(entry_into(table, {0.49, -0.001, 0}, {0.49 + 0.04, -0.001, 0}, {0.49, -0.001, 0}, 0));
  CHECK_FALSE(entry_into(table, {0.6, 0.02, 0}, {0.6, -0.3, 0}, {0.6, 0.02, 0}, 0));
  // Along the top and over its edge
  CHECK_FALSE(entry_into(table, {0.49, 0, 0}, {0.52, -0.001, 0}, {0.49, 0, 0}, 0));
  CHECK_FALSE(entry_into(SphereShape{{0, 0, 0}, 0.1}, {0, 0.12, 0}, {0, 0.05, 0}, {0, 0.12, 0}, 0));
  CHECK_FALSE(entry_into(PlaneShape{{0, 0, 0}, {0, 1, 0}}, {0, 1, 0}, {0, -5, 0}, {0, 1, 0}, 0));
}

TEST_CASE("a point that would be inside a plate that is lifted, if it stayed, meets the plate's top", "[tool]") {
  const ToolShape plate = BoxShape{{0, -0.002, 0}, {0.05, 0.002, 0.05}};
  // In the plate's axes the point stays on top if it goes along, and is 3 or 30 mm below the top if it does not.
  for (const double lifted : {0.003, 0.03}) {
    const auto entry = entry_into(plate, {0.01, 0, 0}, {0.01, 1e-5, 0}, {0.01, -lifted, 0}, 0);
    CAPTURE(lifted);
    REQUIRE(entry);
    CHECK(entry->normal.y() == Approx(1));
    CHECK(entry->offset == Approx(0).margin(1e-12));
  }
  CHECK_FALSE(entry_into(plate, {0.01, 0, 0}, {0.01, 1e-5, 0}, {0.01, -0.001, 0}, 0));
}

TEST_CASE("a ball is entered where the way meets its surface", "[tool]") {
  const auto entry = entry_into(SphereShape{{0, 0, 0}, 0.1}, {0, 0.2, 0}, {0, -0.2, 0}, {0, 0.2, 0}, 0);
  REQUIRE(entry);
  CHECK(entry->normal.y() == Approx(1));
  CHECK(entry->offset == Approx(0.1).margin(1e-12));
}

}  // namespace
}  // namespace fascia
