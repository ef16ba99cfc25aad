// A stroke of the brush, which marks vertices or tets on the tissue.
#include <algorithm>
#include <catch2/catch.hpp>

#include "app/window/brush/stroke.h"
#include "tests/support/headless.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

namespace {

constexpr BrushedPicture kPicture{400, 400};

struct Cube {
  Graphics graphics = open_graphics(headless(), false);
  Session session{graphics, open_scene(source_dir() / "assets/scenes/cube.json"), false};
  const Model& model() const { return session.simulation.model; }
};

double distance_from_ray(const Eigen::Vector3d& place, const Ray& ray) {
  const Eigen::Vector3d off = place - ray.origin;
  return (off - ray.direction * off.dot(ray.direction)).norm();
}

}  // namespace

TEST_CASE("a stroke marks the vertices within the brush, and none beside the tissue") {
  Cube cube;
  const Ray ray = cube.session.camera.ray(200, 200, 400, 400);
  Stroke stroke;
  CHECK_FALSE(stroke.begin({1, 1}, kPicture, cube.session, Stroke::Marks::vertices, 0.02));
  CHECK_FALSE(stroke.under_way());
  CHECK(stroke.places().empty());

  const double radius = 0.02;
  REQUIRE(stroke.begin({200, 200}, kPicture, cube.session, Stroke::Marks::vertices, radius));
  CHECK(stroke.under_way());
  const std::vector<Eigen::Vector3d> first = stroke.places();
  REQUIRE_FALSE(first.empty());
  for (std::size_t i = 1; i < first.size(); ++i)  // all in one ball
    CHECK((first[i] - first[0]).norm() <= 2 * radius + 1e-6);
  stroke.move({210, 230}, kPicture, cube.session, radius);
  CHECK(stroke.places().size() >= first.size());
  stroke.move({1, 1}, kPicture, cube.session, radius);  // beside the tissue: nothing is added
  const std::size_t count = stroke.places().size();
  const std::vector<std::uint32_t> marked = stroke.finish();
  CHECK(marked.size() == count);
  CHECK(std::is_sorted(marked.begin(), marked.end()));
  CHECK_FALSE(stroke.under_way());
  CHECK(stroke.finish().empty());

  INFO("a brush smaller than the mesh's edges marks the vertex nearest to the tissue under the mouse");
  REQUIRE(stroke.begin({200, 200}, kPicture, cube.session, Stroke::Marks::vertices, 1e-9));
  const std::vector<std::uint32_t> nearest = stroke.finish();
  REQUIRE(nearest.size() == 1);
  CHECK(distance_from_ray(cube.model().rest_positions[nearest[0]], ray) < 0.05);
}

TEST_CASE("a stroke marks the tets in a ball around the place at rest, however the tissue is deformed") {
  Cube cube;
  Simulation& simulation = cube.session.simulation;
  const std::vector<Eigen::Vector3d> centers = centroids_of(cube.model().tets, cube.model().rest_positions);
  const double radius = 0.03;
  Stroke stroke;
  const auto painted_at = [&](double x, double y) {
    if (!stroke.begin({x, y}, kPicture, cube.session, Stroke::Marks::tets, radius)) return std::vector<std::uint32_t>();
    return stroke.finish();
  };
  const std::vector<std::uint32_t> at_rest = painted_at(200, 200);
  REQUIRE(at_rest.size() > 1);
  INFO("exactly those of a ball around one place, which is on the surface under the mouse");
  const Ray ray = cube.session.camera.ray(200, 200, 400, 400);
  double most = 0;
  for (const std::uint32_t t : at_rest) most = std::max(most, distance_from_ray(centers[t], ray));
  CHECK(most <= radius + 1e-6);

  INFO("the whole body moved aside: another pixel paints the same tets");
  State state = simulation.state();
  const Eigen::Vector3d aside(0.05, 0, 0);
  for (Eigen::Vector3d& u : state.displacement) u = aside;
  simulation.go_on_from(state);
  const Eigen::Vector3d first = ray.origin + 0.5 * ray.direction;
  cube.session.camera.eye += aside;
  cube.session.camera.target += aside;
  CAPTURE(first.transpose());
  CHECK(painted_at(200, 200) == at_rest);
  INFO("stretched to twice its width: the ball is that at rest");
  for (std::size_t v = 0; v < state.displacement.size(); ++v)
    state.displacement[v] = {cube.model().rest_positions[v].x(), 0, 0};
  simulation.go_on_from(state);
  cube.session.camera.eye -= aside;
  cube.session.camera.target -= aside;
  const std::vector<std::uint32_t> stretched = painted_at(200, 200);
  REQUIRE(stretched.size() > 1);
  Eigen::AlignedBox3d box;
  for (const std::uint32_t t : stretched) box.extend(centers[t]);
  CHECK(box.sizes().maxCoeff() <= 2 * radius + 1e-6);

  INFO("a brush smaller than the tets paints the one under the mouse");
  REQUIRE(stroke.begin({200, 200}, kPicture, cube.session, Stroke::Marks::tets, 1e-9));
  CHECK(stroke.finish().size() == 1);
}

TEST_CASE("a stroke on a section plane paints the inside") {
  Cube cube;
  DisplaySettings display = cube.session.display();
  display.section = SectionPlane{cube.session.camera.forward() * -1, 0};
  cube.session.set_display(display);
  Stroke stroke;
  REQUIRE(stroke.begin({200, 200}, kPicture, cube.session, Stroke::Marks::tets, 0.02));
  const std::vector<std::uint32_t> inside = stroke.finish();
  const std::vector<Eigen::Vector3d> centers = centroids_of(cube.model().tets, cube.model().rest_positions);
  REQUIRE_FALSE(inside.empty());
  for (const std::uint32_t t : inside) CHECK((centers[t] - cube.session.look.center).norm() < 0.02 + 0.03);
}
