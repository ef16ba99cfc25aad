// Parts of a model without support, in models of a few tets.
#include "sim/model/unconstrained_parts.h"

#include <catch2/catch.hpp>

using namespace fascia;

namespace {

/// Three parts: tets 0 and 2 over vertices 0 to 4, tet 1 over 5 to 8, tets 3 and 4, which share one vertex, over 9 to
/// 15. Vertex 16 is in no tet.
Model three_parts() {
  Model model;
  model.rest_positions.resize(17, Eigen::Vector3d(0, 0, 0));
  model.tets = {{0, 1, 2, 3}, {8, 7, 6, 5}, {1, 2, 3, 4}, {12, 11, 10, 9}, {13, 14, 15, 12}};
  model.bodies.resize(2);
  model.bodies[0].name = "a";
  model.bodies[0].vertex_count = 9;
  model.bodies[1].name = "b";
  model.bodies[1].vertex_begin = 9;
  model.bodies[1].vertex_count = 8;
  return model;
}

std::vector<char> held(const std::vector<std::uint32_t>& vertices) {
  std::vector<char> all(17, 0);
  for (const std::uint32_t v : vertices) all[v] = 1;
  return all;
}

using Numbers = std::vector<std::uint32_t>;

}  // namespace

TEST_CASE("a part is what tets connect, and one held vertex holds all of it") {
  const Model model = three_parts();
  const UnconstrainedParts all = unconstrained_parts(model, held({}));
  CHECK(all.parts == 3);
  CHECK(all.vertices == 16);
  CHECK(all.first == 0);
  CHECK(all.held_parts == 0);
  CHECK(all.part == Numbers{1, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3, 3, 3, 3, 0});

  const UnconstrainedParts some = unconstrained_parts(model, held({4, 15}));
  CHECK(some.parts == 1);
  CHECK(some.vertices == 4);
  CHECK(some.first == 5);
  CHECK(some.held_parts == 2);
  CHECK(some.part == Numbers{0, 0, 0, 0, 0, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0});

  const UnconstrainedParts none = unconstrained_parts(model, held({0, 5, 9}));
  CHECK(none.parts == 0);
  CHECK(none.vertices == 0);
  CHECK(none.held_parts == 3);
  CHECK(unconstrained_parts(model, held({16})).held_parts == 0);  // in no tet
}

TEST_CASE("vertices are named as in the file of their body") {
  const Model model = three_parts();
  CHECK(vertex_name(model, 0) == "vertex 0 of a");
  CHECK(vertex_name(model, 8) == "vertex 8 of a");
  CHECK(vertex_name(model, 9) == "vertex 0 of b");
  CHECK(vertex_name(model, 99) == "vertex 99");
}

TEST_CASE("a note names components that fall off a model that is constrained elsewhere") {
  Model model = three_parts();
  CHECK(note_of_unconstrained_parts(model).empty());  // falls as a whole
  model.fixed = {0};
  const std::string end = "): no vertex is fixed or prescribed";
  CHECK(note_of_unconstrained_parts(model) ==
        "2 components of 11 vertices in all are unconstrained and will fall (vertex 5 of a" + end);
  ResolvedGrab grab;
  grab.grip = {{6, {0, 0, 0}, 1}};
  model.grabs = {grab};
  CHECK(note_of_unconstrained_parts(model) ==
        "1 component of 7 vertices in all is unconstrained and will fall (vertex 0 of b" + end);
  model.gravity.setZero();
  CHECK(note_of_unconstrained_parts(model).empty());
}
