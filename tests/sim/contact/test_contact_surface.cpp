#include "sim/contact/contact_surface.h"

#include <catch2/catch.hpp>
#include <numeric>

#include "sim/tool/shape_distance.h"
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

// E (1 - nu) / ((1 + nu) (1 - 2 nu)), 1.346 E and 3.793 E.
TEST_CASE("the penalty grows with Poisson's ratio to 0.45, and no further", "[contact]") {
  const auto stiffness_at = [](double poisson_ratio) {
    Model model = box_with(SphereShape{{0, 0, 0}, 1.0});
    for (Material& material : model.materials) material.poisson_ratio = poisson_ratio;
    return contact_stiffness(model, make_contact_surface(model)).at(0);
  };
  const double at_three_tenths = stiffness_at(0.3);
  CHECK(stiffness_at(0.45) / at_three_tenths == Approx(3.793 / 1.346).epsilon(1e-3));
  CHECK(stiffness_at(0.49) == stiffness_at(0.45));
  CHECK(stiffness_at(0.499) == stiffness_at(0.45));
}

// Cells of 10 x 10 x 10 cm: diagonals of 17 cm. Points of level 2 are 4.3 cm apart.
TEST_CASE("a tool with sharp edges that slides is told", "[contact]") {
  const auto notes = [](const ToolShape& shape, const std::vector<Vector3d>& way) {
    Model model = box_with(shape);
    model.tools[0].path.clear();
    for (const Vector3d& place : way)
      model.tools[0].path.push_back({static_cast<double>(model.tools[0].path.size()), place, {0, 0, 0}, 0});
    return make_contact_surface(model).notes;
  };
  const std::vector<Vector3d> straight = {{0, 1, 0}, {0, 0, 0}, {0, 1, 0}}, slides = {{0, 1, 0}, {0, 0, 0}, {1, 0, 0}};
  const CylinderShape sharp{{0, 0, 0}, {0, 2, 0}, 1}, round{{0, 0, 0}, {0, 2, 0}, 1, 0.02};
  CHECK(notes(sharp, slides) == std::vector<std::string>{"tool: may hook into tissue with its sharp edges where it "
                                                         "slides; a round of 0.018 m helps"});
  CHECK(notes(sharp, straight).empty());
  CHECK(notes(round, slides).empty());
}

TEST_CASE("tools have more points around sharp edges", "[contact]") {
  const auto levels_of = [](const ToolShape& shape) {
    const ContactSurface surface = make_contact_surface(box_with(shape));
    const ContactSurface everywhere = make_contact_surface(box_with(SphereShape{{0, 0, 0}, finest_radius(shape)}));
    CHECK(surface.pieces[0].everywhere == everywhere.pieces[0].points);
    return std::pair(everywhere.pieces[0].level, surface.pieces[0].level);
  };
  CHECK(levels_of(BoxShape{{0, 0, 0}, {1, 1, 1}, 0}) == std::pair(0, 2));
  CHECK(levels_of(BoxShape{{0, 0, 0}, {1, 1, 1}, 0.2}) == std::pair(0, 1));
  CHECK(levels_of(BoxShape{{0, 0, 0}, {1, 1, 1}, 0.5}) == std::pair(0, 0));
  CHECK(levels_of(BoxShape{{0, 0, 0}, {1, 0.05, 1}, 0}) == std::pair(3, 3));
  CHECK(levels_of(CylinderShape{{0, 0, 0}, {0, 2, 0}, 1}) == std::pair(0, 2));
  CHECK(levels_of(PlaneShape{{0, 0, 0}, {0, 1, 0}}) == std::pair(0, 0));
}

TEST_CASE("tools thinner than the finest points are told", "[contact]") {
  CHECK(make_contact_surface(box_with(SphereShape{{0, 0, 0}, 0.05})).notes.empty());
  const ContactSurface surface = make_contact_surface(box_with(SphereShape{{0, 0, 0}, 1e-3}));
  REQUIRE(surface.notes.size() == 1);
  CHECK(surface.notes[0].find("tool: contact points are") == 0);
}

// Cells of 10 cm, with diagonals: the mean edge of the surface is between 10 and 18 cm.
TEST_CASE("a skin that is thick beside the tissue is told, one thicker than a body refused", "[contact]") {
  const auto notes_with = [](double thickness, int cells = 3) {
    Model model = test::box_model(cells, cells, cells, {0.3, 0.3, 0.3}, test::soft(1e5));
    BodyPart& body = model.bodies.emplace_back();
    body.name = "body";
    body.vertex_count = static_cast<std::uint32_t>(model.rest_positions.size());
    model.contact.thickness = thickness;
    model.tools = box_with(PlaneShape{{0, 0, 0}, {0, 1, 0}}).tools;
    return check_contact(model, "s.json");
  };
  CHECK(notes_with(0).empty());
  CHECK(notes_with(0.09).empty());
  REQUIRE(notes_with(0.14, 6).size() == 1);
  CHECK(notes_with(0.14, 6)[0].find("contact.thickness of 0.14 m is more than the elements of body, 0.0") == 0);
  REQUIRE(notes_with(0.2).size() == 1);
  CHECK(notes_with(0.2)[0] ==
        "contact.thickness of 0.2 m is more than half of the smallest side of body, 0.15 m: contact may crush it");
  CHECK_THROWS_WITH(
      notes_with(0.31),
      Catch::StartsWith("s.json: contact.thickness: is 0.31 m, more than the largest side of body, 0.3 m; "
                        "expected less than its elements, 0.1"));
}

TEST_CASE("a tool that begins wholly inside tissue is told", "[contact]") {
  const auto notes_at = [](const Vector3d& place, const ToolShape& shape) {
    Model model = box_with(shape);
    model.tools[0].path[0].position = place;
    return check_contact(model, "s.json");
  };
  const ToolShape ball = SphereShape{{0, 0, 0}, 0.05}, rod = CapsuleShape{{0, 0, 0}, {0, 0.4, 0}, 0.05};
  REQUIRE(notes_at({0.1, 0.15, 0.1}, ball).size() == 1);
  CHECK(notes_at({0.1, 0.15, 0.1}, ball)[0] ==
        "tool: begins wholly inside tissue, and touches nothing until the surface reaches it");
  CHECK(notes_at({0.1, 0.26, 0.1}, ball).empty());  // touches the top from inside
  CHECK(notes_at({0.1, 0.4, 0.1}, ball).empty());
  CHECK(notes_at({0.1, 0.05, 0.1}, rod).empty());  // its middle is inside, its end sticks out
}

/// The box as a body, which notes name.
Model body_with(const ToolShape& shape) {
  Model model = box_with(shape);
  model.bodies = {{"box",
                   0,
                   static_cast<std::uint32_t>(model.rest_positions.size()),
                   0,
                   static_cast<std::uint32_t>(model.tets.size()),
                   0,
                   1,
                   {}}};
  return model;
}

TEST_CASE("a body that begins inside both jaws of an instrument is told once", "[contact]") {
  Model model = body_with(SphereShape{{0.1, 0, 0}, 0.09});
  Tool& tool = model.tools[0];
  tool.has_jaws = true;  // around the lower left corner of the box and the lower right one
  tool.path[0].position = {0.1, 0, 0};
  tool.mirror.axes.diagonal() << -1, 1, 1;
  const std::vector<std::string> notes = check_contact(model, "s.json");
  REQUIRE(notes.size() == 1);
  CHECK_THAT(notes[0], Catch::StartsWith("box: 2 of 34 vertices of its surface begin inside tool, up to 90 mm deep"));
}

TEST_CASE("a body that begins inside a tool is told", "[contact]") {
  const auto notes_at = [](double height) {
    Model model = body_with(PlaneShape{{0, 0, 0}, {0, 1, 0}});
    model.tools[0].path.resize(1);
    model.tools[0].path[0].position.y() = height;
    return check_contact(model, "s.json");
  };
  CHECK(notes_at(0).empty());
  CHECK(notes_at(1e-3).empty());
  REQUIRE(notes_at(0.01).size() == 1);
  CHECK_THAT(notes_at(0.01)[0],
             Catch::EndsWith(" of its surface begin inside tool, up to 10 mm deep: contact pushes them "
                             "out within a step"));
  CHECK_THAT(notes_at(1)[0],
             Catch::StartsWith("box: ") && Catch::EndsWith(" begin inside tool, up to 1 m deep: is tool as "
                                                           "large as it should be, and in its place?"));
}

TEST_CASE("more rigid pieces than the GPU tells apart are refused", "[contact]") {
  Model model = box_with(SphereShape{{0, 0, 0}, 0.2});
  model.tools[0].path[0].position = {0, 2, 0};
  model.tools.resize(ContactSurface::kMostPieces, model.tools[0]);
  CHECK(check_contact(model, "s.json").empty());
  model.tools[0].has_jaws = true;
  CHECK_THROWS_WITH(
      check_contact(model, "s.json"),
      "s.json: contact: has 33 rigid pieces; expected at most 32: ground, obstacles, instruments, jaws as two");
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
