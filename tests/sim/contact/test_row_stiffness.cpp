#include "sim/contact/row_stiffness.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>

#include "tests/sim/reference/box_model.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

// A slab of 20 x 10 x 20 cm with cells of 5 cm, and a plate of 1 cm above it, on which it has the points of the finest
// level, in its whole top or in a part of it.
struct UnderPlate {
  Model model = test::box_model(4, 2, 4, {0.2, 0.1, 0.2}, test::soft(1e5));
  ContactSurface surface;
  std::vector<double> stiffness;
  std::vector<Vector3d> still;

  explicit UnderPlate(const ToolShape& shape = BoxShape{{0.1, 0.1055, 0.1}, {0.2, 0.005, 0.2}, 0}) {
    Tool plate;
    plate.name = "plate";
    plate.shape = shape;
    plate.path.emplace_back();
    model.tools = {plate};
    surface = make_contact_surface(model);
    stiffness = contact_stiffness(model, surface);
    still.assign(model.rest_positions.size(), Vector3d(0, 0, 0));
  }
  Vector3d place(std::uint32_t p) const {
    Vector3d x(0, 0, 0);
    for (std::size_t k = 0; k < 3; ++k)
      x += surface.points[p].weights[k] * model.rest_positions[surface.points[p].vertices[k]];
    return x;
  }
  std::vector<double> rows(const ContactMemory& memory, const std::vector<Vector3d>& ahead) const {
    return row_stiffness(model, surface, stiffness, memory, motion_on_paths(model.tools, 0, 0), still, ahead);
  }
  std::vector<Vector3d> moved_up(double way) const {
    std::vector<Vector3d> u = still;
    for (Vector3d& each : u) each.y() = way;
    return u;
  }
  double on_top(const std::vector<double>& of_points, bool vertices_alone) const {
    double sum = 0;
    for (std::uint32_t p = 0; p < surface.points.size(); ++p)
      if (place(p).y() > 0.1 - 1e-9 && (!vertices_alone || surface.points[p].weights[0] == 1)) sum += of_points[p];
    return sum;
  }
};

TEST_CASE("points that all press share the stiffness of the vertices", "[contact]") {
  const UnderPlate under;
  const ContactPiece& piece = under.surface.pieces.at(0);
  REQUIRE(piece.level == 3);
  ContactMemory memory(under.surface.row_count);
  for (std::uint32_t p = 0; p < piece.points; ++p)
    if (under.place(p).y() > 0.1 - 1e-9) memory[p].normal = 2;
  const double vertices = under.on_top(under.stiffness, true), alone = under.on_top(under.stiffness, false);
  // By forces that they bear, or, before they bear any, by those of a way into the plate.
  const double bearing = under.on_top(under.rows(memory, under.still), false),
               coming = under.on_top(under.rows({}, under.moved_up(1e-3)), false),
               apart = under.on_top(under.rows({}, under.moved_up(-1e-2)), false);
  CAPTURE(vertices, alone, bearing, coming, apart);
  CHECK(alone > 30 * vertices);
  // At the rim of the plate's top fewer points are around a vertex than within.
  CHECK(bearing == Approx(vertices).epsilon(0.1));
  CHECK(coming == Approx(vertices).epsilon(0.1));
  CHECK(apart == Approx(alone));
}

TEST_CASE("rounding does not say how many points share a first touch", "[contact]") {
  const UnderPlate under;
  // On the plate, which is half a millimeter above, but for what float32 would lose.
  std::vector<Vector3d> ahead = under.moved_up(5e-4);
  const double even = under.on_top(under.rows({}, ahead), false);
  for (std::size_t v = 0; v < ahead.size(); ++v) ahead[v].y() += 1e-8 * std::sin(7.0 * static_cast<double>(v));
  const double uneven = under.on_top(under.rows({}, ahead), false), vertices = under.on_top(under.stiffness, true);
  CAPTURE(even, uneven, vertices);
  CHECK(even == Approx(vertices).epsilon(0.1));
  CHECK(uneven == Approx(even).epsilon(1e-4));
}

TEST_CASE("few points that press are as stiff as the tissue below them", "[contact]") {
  const UnderPlate under;
  for (const std::size_t count : {1, 3}) {
    ContactMemory memory(under.surface.row_count);
    std::vector<std::uint32_t> pressing;
    for (std::uint32_t p = under.surface.pieces[0].points; p-- > 0 && pressing.size() < count;)
      if (under.place(p).y() > 0.1 - 1e-9) pressing.push_back(p);
    for (const std::uint32_t p : pressing) memory[p].normal = 2;
    const std::vector<double> rows = under.rows(memory, under.still);
    for (const std::uint32_t p : pressing) {
      CAPTURE(count, p, rows[p], under.stiffness[p]);
      CHECK(rows[p] <= under.stiffness[p]);
      CHECK(rows[p] >= (count == 1 ? 1 : 0.5) * under.stiffness[p]);
    }
  }
}

TEST_CASE("fine points of a large box have rows near its edges, and where they press", "[contact]") {
  // Its edge is above the middle of the slab.
  const UnderPlate under(BoxShape{{0, 0.3, 0.1}, {0.1, 0.2, 0.4}, 0});
  const ContactPiece& piece = under.surface.pieces.at(0);
  REQUIRE(piece.everywhere < piece.points);
  ContactMemory memory(under.surface.row_count);
  const std::uint32_t pressed = piece.points - 1;
  memory[pressed].normal = 1;
  const std::vector<double> rows = under.rows(memory, under.still);
  for (std::uint32_t p = 0; p < piece.points; ++p) {
    const Vector3d x = under.place(p);
    const bool at_edge = std::abs(x.x() - 0.1) < under.surface.edge_width || x.x() > 0.1;
    CAPTURE(p, x.transpose(), rows[p], under.surface.edge_width);
    // What is beyond the edge on its own side, and below, is nearest to it.
    if (p < piece.everywhere || p == pressed)
      CHECK(rows[p] > 0);
    else if (x.y() > 0.1 - 1e-9)
      CHECK((rows[p] > 0) == at_edge);
  }
}

}  // namespace
}  // namespace fascia
