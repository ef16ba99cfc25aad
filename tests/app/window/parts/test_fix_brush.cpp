// The brush that marks vertices on the tissue.
#include <algorithm>
#include <catch2/catch.hpp>

#include "app/window/parts/fix_brush.h"
#include "tests/support/headless.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

TEST_CASE("a stroke marks the vertices within the brush, and none beside the tissue") {
  Graphics graphics = open_graphics(headless(), false);
  Session session(graphics, open_scene(source_dir() / "assets/scenes/cube.json"), false);
  const FixBrush::Picture picture{400, 400};
  const auto ray = session.camera.ray(200, 200, 400, 400);
  FixBrush brush;
  CHECK_FALSE(brush.begin({1, 1}, picture, session, 0.02));
  CHECK_FALSE(brush.painting());
  CHECK(brush.places().empty());

  const double radius = 0.02;
  REQUIRE(brush.begin({200, 200}, picture, session, radius));
  CHECK(brush.painting());
  const std::vector<Eigen::Vector3d> first = brush.places();
  REQUIRE_FALSE(first.empty());
  for (std::size_t i = 1; i < first.size(); ++i)  // all in one ball
    CHECK((first[i] - first[0]).norm() <= 2 * radius + 1e-6);
  brush.move({210, 230}, picture, session, radius);
  CHECK(brush.places().size() >= first.size());
  brush.move({1, 1}, picture, session, radius);  // beside the tissue: nothing is added
  const std::size_t count = brush.places().size();
  const std::vector<std::uint32_t> marked = brush.finish();
  CHECK(marked.size() == count);
  CHECK(std::is_sorted(marked.begin(), marked.end()));
  CHECK_FALSE(brush.painting());
  CHECK(brush.finish().empty());

  INFO("a brush smaller than the mesh's edges marks the vertex nearest to the tissue under the mouse");
  REQUIRE(brush.begin({200, 200}, picture, session, 1e-9));
  const std::vector<std::uint32_t> nearest = brush.finish();
  REQUIRE(nearest.size() == 1);
  const Eigen::Vector3d off = session.simulation.model.rest_positions[nearest[0]] - ray.origin;
  CHECK((off - ray.direction.normalized() * off.dot(ray.direction.normalized())).norm() < 0.05);
}
