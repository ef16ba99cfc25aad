#include "sim/contact/contact_surface.h"

#include <catch2/catch.hpp>
#include <numeric>

#include "tests/sim/reference/box_model.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

Model box_with(const ToolShape& shape) {
  Model model = test::box_model(2, 3, 2, {0.2, 0.3, 0.2}, test::soft(1e5));
  Tool tool;
  tool.name = "tool";
  tool.shape = shape;
  tool.path.emplace_back();
  model.tools = {tool};
  return model;
}

TEST_CASE("contact points of every level share the whole surface", "[contact]") {
  const double area = 2 * (0.2 * 0.3 + 0.2 * 0.2 + 0.3 * 0.2);
  for (const auto& [radius, level] : {std::pair{1.0, 0}, {0.2, 1}, {0.1, 2}, {0.05, 3}}) {
    const Model model = box_with(SphereShape{{0, 0, 0}, radius});
    const ContactSurface surface = make_contact_surface(model);
    REQUIRE(surface.pieces.size() == 1);
    CAPTURE(radius, level, surface.pieces[0].level, surface.points.size());
    CHECK(surface.pieces[0].level == level);
    double sum = 0;
    for (const ContactPoint& point : surface.points) {
      sum += point.area / std::pow(4.0, level);
      CHECK(std::accumulate(point.weights.begin(), point.weights.end(), 0.0) == Approx(1));
    }
    CHECK(sum == Approx(area));
    CHECK(surface.row_count == surface.points.size());
  }
  // A closed surface of V vertices has 3 (V - 2) edges (Euler).
  const std::size_t vertices = make_contact_surface(box_with(SphereShape{{0, 0, 0}, 1.0})).points.size(),
                    with_edges = make_contact_surface(box_with(SphereShape{{0, 0, 0}, 0.2})).points.size();
  CHECK(with_edges - vertices == 3 * (vertices - 2));
}

TEST_CASE("tools thinner than the finest points are told", "[contact]") {
  CHECK(make_contact_surface(box_with(SphereShape{{0, 0, 0}, 0.05})).notes.empty());
  const ContactSurface surface = make_contact_surface(box_with(SphereShape{{0, 0, 0}, 1e-3}));
  REQUIRE(surface.notes.size() == 1);
  CHECK(surface.notes[0].find("tool: contact points are") == 0);
}

TEST_CASE("the faces of quadratic tets have contact points in the middle of their edges", "[contact]") {
  Model model = test::quadratic(box_with(PlaneShape{{0, 0, 0}, {0, 1, 0}}));
  const ContactSurface surface = make_contact_surface(model);
  double sum = 0;
  for (const ContactPoint& point : surface.points) sum += point.area;
  CHECK(sum == Approx(2 * (0.2 * 0.3 + 0.2 * 0.2 + 0.3 * 0.2)));
  const auto last = std::max_element(surface.points.begin(), surface.points.end(),
                                     [](const auto& a, const auto& b) { return a.vertices[0] < b.vertices[0]; });
  CHECK(last->vertices[0] >= test::box_model(2, 3, 2, {1, 1, 1}, {}).rest_positions.size());
}

}  // namespace
}  // namespace fascia
