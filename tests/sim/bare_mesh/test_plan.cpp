#include "sim/bare_mesh/plan.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/support/bare_shapes.h"

using namespace fascia;
using namespace fascia::test;

namespace {

BareMeshPlan plan_of(const TetMesh& mesh, const std::string& file = "mesh.vtk", const Unsettled& open = {},
                     const Body& body = {}) {
  return plan_bare_mesh(file, mesh, mesh.tets, open, body, 9.81);
}

LowestSelection support_of(const BareMeshPlan& plan) {
  REQUIRE(plan.fixed.size() == 1);
  return std::get<LowestSelection>(plan.fixed[0]);
}

}  // namespace

TEST_CASE("a size that is not that of tissue in meters is one in mm, then in um") {
  const auto unit_of = [](double extent) { return plan_of(make_box(2, 2, 2, {extent, extent, extent})).unit; };
  for (const double extent : {1e-5, 0.01, 0.2, 3.0}) CHECK(unit_of(extent) == LengthUnit::m);
  for (const double extent : {3.1, 60.0, 480.0, 3000.0}) CHECK(unit_of(extent) == LengthUnit::mm);
  for (const double extent : {3100.0, 2e6}) CHECK(unit_of(extent) == LengthUnit::um);
  CHECK(unit_of(1e9) == LengthUnit::m);
  const BareMeshPlan plan = plan_of(make_box(2, 2, 2, {120, 90, 60}));
  CHECK(plan.unit_reason == "120 mm wide");
  const TetMesh fill = make_box(2, 2, 2, {64.6, 64.6, 64.6});  // whose tets stick out of the surface
  CHECK(plan_bare_mesh("ball.stl", fill, fill.tets, {}, {}, 9.81, 60).unit_reason == "60 mm wide");
  Body in_inches;
  in_inches.unit = LengthUnit::in;
  CHECK(plan_of(make_box(1, 1, 1, {120, 90, 60}), "a.msh", {false, true, true, true, true, {}}, in_inches).unit ==
        LengthUnit::in);
}

TEST_CASE("a body stands on its flat side, whichever axis that is along") {
  for (const int axis : {0, 1, 2}) {
    CAPTURE(axis);
    const BareMeshPlan plan = plan_of(turned(make_cone(0.05, 0.1), axis));
    CHECK(plan.up == kUpAxes[static_cast<std::size_t>(axis)]);
    CHECK(plan.up_reason == "stands on its flat side");
    CHECK(!support_of(plan).highest);
  }
}

TEST_CASE("the usual axis wins where several sides are flat, and files have different ones") {
  const TetMesh box = make_box(3, 3, 3, {0.1, 0.12, 0.14});
  CHECK(plan_of(box, "box.msh").up == UpAxis::y);
  CHECK(plan_of(box, "box.obj").up == UpAxis::y);
  CHECK(plan_of(box, "box.stl").up == UpAxis::z);
  CHECK(plan_of(scaled(box, 1000), "box.msh").up == UpAxis::z);  // in mm
  CHECK(plan_of(scaled(box, 1000), "box.obj").up == UpAxis::y);
  CHECK(plan_of(make_ball(0.1), "ball.msh").up == UpAxis::y);
  CHECK(plan_of(make_ball(100), "ball.msh").up == UpAxis::z);
}

TEST_CASE("a ring lies on its rim, whatever the ending of its file") {
  TetMesh ring = make_box(40, 8, 8, {1, 2, 2});  // around y, and all but closed
  deform(ring, [](const Eigen::Vector3d& p) {
    const Eigen::Vector2d disc = 0.004 * round(Eigen::Vector2d(p.y() - 1, p.z() - 1));
    const double angle = -6.2 * p.x(), r = 0.04 + disc.y();
    return Eigen::Vector3d(r * std::cos(angle), disc.x(), r * std::sin(angle));
  });
  for (const int axis : {0, 1, 2})
    for (const char* file : {"ring.obj", "ring.stl", "ring.msh"}) {
      CAPTURE(axis, file);
      CHECK(plan_of(turned(ring, axis), file).up == kUpAxes[static_cast<std::size_t>(axis)]);
    }
}

TEST_CASE("a body that is flat at its top only hangs from it") {
  TetMesh tip_down = make_cone(0.05, 0.1);
  for (Eigen::Vector3d& p : tip_down.positions) p.y() = -p.y();
  for (Tet& t : tip_down.tets) std::swap(t[0], t[1]);
  const BareMeshPlan plan = plan_of(tip_down);
  CHECK(plan.up == UpAxis::y);
  CHECK(support_of(plan) == LowestSelection{0.02, true});
  CHECK(plan_of(turned(tip_down, 2)).up == UpAxis::z);
  CHECK(support_of(plan_of(turned(tip_down, 2))).highest);
  const BareMeshPlan over = plan_of(turned(tip_down, 0));  // x rarely points up
  CHECK(over.up == UpAxis::minus_x);
  CHECK(!support_of(over).highest);
}

TEST_CASE("feet that are far apart carry a body that is flat at its top") {
  TetMesh table = make_box(6, 4, 6, {0.6, 0.4, 0.6});
  std::erase_if(table.tets, [&](const Tet& t) {
    Eigen::Vector3d center(0, 0, 0);
    for (const std::uint32_t v : t) center += table.positions[v] / 4;
    const auto inner = [](double x) { return x > 0.1 && x < 0.5; };
    return center.y() < 0.3 && (inner(center.x()) || inner(center.z()));
  });
  const BareMeshPlan plan = plan_of(table);
  CHECK(plan.up == UpAxis::y);
  CHECK(support_of(plan) == LowestSelection{0.02});
}

TEST_CASE("what is too slender to stand lies") {
  CHECK(plan_of(make_box(2, 12, 2, {0.1, 0.5, 0.1})).up == UpAxis::y);
  CHECK(plan_of(make_box(2, 30, 2, {0.1, 1.5, 0.1})).up != UpAxis::y);
  TetMesh spindle = make_ball(0.1);
  for (Eigen::Vector3d& p : spindle.positions) p.y() *= 4;
  const BareMeshPlan plan = plan_of(spindle);
  CHECK(plan.up == UpAxis::z);
  CHECK(plan.up_reason == "slender, lies down");
}

TEST_CASE("a round body is held by as much of its lower part as carries it") {
  CHECK(support_of(plan_of(make_box(3, 3, 3, {0.1, 0.1, 0.1}))).share == 0.02);
  CHECK(support_of(plan_of(make_ball(0.1))).share == 0.02);
  TetMesh egg = make_ball(0.05);
  for (Eigen::Vector3d& p : egg.positions) p.y() *= 2.5;
  CHECK(plan_of(egg).up == UpAxis::y);
  CHECK(support_of(plan_of(egg)).share == 0.05);
}

TEST_CASE("every piece is held") {
  const TetMesh two = together(make_box(2, 2, 2, {0.1, 0.1, 0.1}), make_ball(0.05, 4), {0, 0.5, 0});
  const BareMeshPlan plan = plan_of(two);
  CHECK(support_of(plan).each_piece);
  CHECK_THAT(plan.support_reason, Catch::EndsWith("of each of its 2 pieces"));
}

TEST_CASE("a group that is named for it holds the mesh") {
  TetMesh mesh = make_box(4, 2, 2, {0.4, 0.1, 0.1});
  mesh.groups["everything"] = {};
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    if (mesh.positions[v].x() == 0) mesh.groups["Fixed_End"].push_back(v);
    mesh.groups["support_all"].push_back(v);  // most of the mesh: no support
  }
  const BareMeshPlan plan = plan_of(mesh);
  CHECK(plan.fixed == std::vector<Selection>{GroupSelection{"Fixed_End"}});
  CHECK(plan.support_reason == "held by the group Fixed_End");
}

TEST_CASE("the weight strains the body by some percent, whatever its size") {
  for (const double size : {1e-5, 0.01, 0.2, 2.0, 150.0}) {
    CAPTURE(size);
    const BareMeshPlan plan = plan_of(make_ball(size / 2));
    const double pressure = 1000 * 9.81 * size * meters(plan.unit);  // rho g h [Pa]
    CHECK(plan.young_modulus > 3 * pressure);
    CHECK(plan.young_modulus < 100 * pressure);
  }
  const BareMeshPlan cube = plan_of(make_box(5, 5, 5, {0.1, 0.1, 0.1}));
  CHECK(cube.young_modulus == Approx(20 * 981).epsilon(0.2));
  CHECK_THAT(cube.stiffness_reason, Catch::StartsWith("its weight strains it by 5"));
}

TEST_CASE("a speck that can turn does not make the body stiff") {
  const TetMesh cube = make_box(5, 5, 5, {0.1, 0.1, 0.1});
  const BareMeshPlan plan = plan_of(together(cube, make_ball(0.003, 2), {0.2, 0.05, 0.05}));
  REQUIRE(support_of(plan).each_piece);
  CHECK(plan.young_modulus == Approx(plan_of(cube).young_modulus).epsilon(0.1));
}

TEST_CASE("a column is so stiff that its weight does not buckle it") {
  const double h = 0.5, w = 0.1;
  const BareMeshPlan plan = plan_of(make_box(4, 20, 4, {w, h, w}));
  REQUIRE(plan.up == UpAxis::y);
  const double critical = 1000 * 9.81 * h * h * h * 12 / (7.84 * w * w);  // Greenhill 1881
  CHECK(plan.young_modulus > 2 * critical);
}

TEST_CASE("given values stay, and the others follow from them") {
  Body body;
  body.up = UpAxis::minus_z;
  body.material.young_modulus = 7e6;
  body.material.model = MaterialModel::neo_hookean;
  body.fixed = {LowestSelection{0.4}};
  const BareMeshPlan given =
      plan_of(make_cone(50, 100), "cone.vtk", {true, false, false, false, false, {"up=-z"}}, body);
  CHECK(given.unit == LengthUnit::mm);
  CHECK(given.up == UpAxis::minus_z);
  CHECK(given.fixed == body.fixed);
  CHECK(given.young_modulus == 7e6);
  CHECK(given.law == MaterialModel::neo_hookean);
  CHECK(given.overrides == std::vector<std::string>{"up=-z"});
  CHECK(text_of(given) ==
        "taken as mm (100 mm wide), -z up (as given), held as given, E 7 MPa (as given); --unit, --up and --set change "
        "it");
  CHECK(plan_of(make_cone(50, 100)).law == MaterialModel::squared);
}

TEST_CASE("the same mesh has the same plan") {
  const TetMesh mesh = make_cone(50, 100);
  CHECK(text_of(plan_of(mesh)) == text_of(plan_of(mesh)));
}

TEST_CASE("what stands on a flat side behind a rim is held up to that side") {
  TetMesh box = make_box(8, 8, 8, {0.4, 0.4, 0.4});
  for (Eigen::Vector3d& p : box.positions)
    if (std::min({p.x(), p.z(), 0.4 - p.x(), 0.4 - p.z()}) < 1e-9 && p.y() < 1e-9) p.y() -= 0.03;
  const BareMeshPlan plan = plan_of(box);
  CHECK(plan.up_reason == "stands on its flat side");
  CHECK(support_of(plan).share == Approx(0.02 + 0.03 / 0.43).epsilon(1e-9));
}

TEST_CASE("an axis that is stated is held as one that is guessed") {
  TetMesh box = make_box(8, 8, 8, {0.4, 0.4, 0.4});
  for (Eigen::Vector3d& p : box.positions)
    if (std::min({p.x(), p.z(), 0.4 - p.x(), 0.4 - p.z()}) < 1e-9 && p.y() < 1e-9) p.y() -= 0.03;
  const TetMesh cone = make_cone(50, 100);  // flat at one end
  for (const TetMesh& mesh : {box, cone}) {
    const BareMeshPlan guessed = plan_of(mesh);
    Unsettled open;
    open.up = false;
    Body body;
    body.up = guessed.up;
    const BareMeshPlan stated = plan_of(mesh, "mesh.vtk", open, body);
    CAPTURE(name_of(guessed.up), guessed.support_reason, stated.support_reason);
    CHECK(stated.up_reason == "as given");
    CHECK(stated.fixed == guessed.fixed);
    CHECK(stated.support_reason == guessed.support_reason);
    CHECK(stated.young_modulus == guessed.young_modulus);
  }
  Unsettled open;
  open.up = false;
  Body body;
  body.up = UpAxis::minus_y;
  CHECK(support_of(plan_of(box, "mesh.vtk", open, body)).share == Approx(0.02));  // the other end, without a rim
}

TEST_CASE("no stiffness is guessed for a body that turns about what holds it") {
  const TetMesh box = make_box(3, 3, 3, {0.1, 0.1, 0.1});
  Unsettled open;
  open.supports = false;
  Body body;
  body.fixed.push_back(BoxSelection{{-1, -1, -1}, {1e-6, 1e-6, 1e-6}});
  const BareMeshPlan corner = plan_of(box, "mesh.vtk", open, body);
  CHECK(corner.young_modulus == body.material.young_modulus);
  CHECK(corner.stiffness_reason == "not guessed: held at 1 point, it can turn");
  body.fixed = {BoxSelection{{-1, -1, -1}, {1, 1e-6, 1e-6}}};
  CHECK(plan_of(box, "mesh.vtk", open, body).stiffness_reason == "not guessed: held at 4 points, it can turn");
  body.fixed = {BoxSelection{{-1, -1, -1}, {1, 1e-6, 1}}};
  CHECK(plan_of(box, "mesh.vtk", open, body).young_modulus != body.material.young_modulus);
}
