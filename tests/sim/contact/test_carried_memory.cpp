#include "sim/contact/carried_memory.h"

#include <catch2/catch.hpp>

#include "sim/contact/contact_surface.h"
#include "tests/sim/reference/box_model.h"

namespace fascia {
namespace {

Tool tool_of(const std::string& name, const ToolShape& shape) {
  Tool tool;
  tool.name = name;
  tool.shape = shape;
  tool.path.emplace_back();
  return tool;
}

// A number of its own for each row, and five rows of the tissue behind those of the tools.
ContactMemory numbered(const Model& model) {
  ContactMemory memory(make_contact_surface(model).row_count + 5);
  for (std::size_t row = 0; row < memory.size(); ++row) memory[row].normal = 1.0 + static_cast<double>(row);
  return memory;
}

TEST_CASE("contact of tools and tissue is remembered where other tools come or go", "[contact]") {
  Model one = test::box_model(2, 3, 2, {0.2, 0.3, 0.2}, test::soft(1e5));
  const Tool ground = tool_of("ground", PlaneShape{{0, 0, 0}, {0, 1, 0}}),
             ball = tool_of("ball", SphereShape{{0, 1, 0}, 0.05}),
             plate = tool_of("plate", BoxShape{{0, 1, 0}, {1, 1, 1}, 1});
  one.tools = {ground, plate};
  Model more = one;
  more.tools = {ground, ball, plate};
  const ContactMemory memory = numbered(one), with_ball = carried_memory(one, memory, more);
  const ContactSurface before = make_contact_surface(one), now = make_contact_surface(more);
  REQUIRE(with_ball.size() == now.row_count + 5);
  for (const std::size_t piece : {0, 2}) {
    const std::uint32_t was = before.pieces[piece / 2].first_row, is = now.pieces[piece].first_row;
    for (std::uint32_t p = 0; p < now.pieces[piece].points; ++p)
      CHECK(with_ball[is + p].normal == memory[was + p].normal);
  }
  for (std::uint32_t p = 0; p < now.pieces[1].points; ++p) CHECK(with_ball[now.pieces[1].first_row + p].normal == 0);
  for (std::size_t k = 1; k <= 5; ++k)
    CHECK(with_ball[with_ball.size() - k].normal == memory[memory.size() - k].normal);
  CHECK(carried_memory(more, with_ball, one) == memory);
}

TEST_CASE("other tissue remembers no contact", "[contact]") {
  Model one = test::box_model(2, 3, 2, {0.2, 0.3, 0.2}, test::soft(1e5));
  one.tools = {tool_of("ground", PlaneShape{{0, 0, 0}, {0, 1, 0}})};
  Model finer = test::box_model(3, 3, 2, {0.2, 0.3, 0.2}, test::soft(1e5)), held = one;
  finer.tools = one.tools;
  held.fixed = {0};
  CHECK(carried_memory(one, numbered(one), finer).empty());
  CHECK(carried_memory(one, numbered(one), held).empty());
  CHECK(carried_memory(one, {}, one).empty());
}

}  // namespace
}  // namespace fascia
