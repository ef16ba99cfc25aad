#include "sim/tool/tool_size.h"

#include <catch2/catch.hpp>

#include "sim/tool/solid_mesh.h"
#include "tests/support/surfaces.h"

using namespace fascia;

TEST_CASE("a tool's mesh that is read in the wrong unit is noticed by its size", "[contact]") {
  const auto note = [](double scale, double tissue) {
    Tool tool;
    tool.name = "spoon";
    MeshShape mesh;
    mesh.solid = std::make_shared<const SolidMesh>(solid_of(test::make_box_surface({200, 20, 40}), scale, "spoon.obj"));
    tool.shape = mesh;
    return note_of_size(tool, tissue);
  };
  CHECK(note(1, 0.1) ==
        "spoon: 200 m wide, 2000 times as large as the tissue: is \"scale\" of its mesh missing (0.001 for "
        "millimeters)?");
  CHECK(!note(0.0254, 0.1).empty());
  CHECK(note(0.001, 0.1).empty());
  CHECK(note(0.01, 0.1).empty());  // a table
  Tool ground;
  ground.shape = PlaneShape{};
  CHECK(note_of_size(ground, 0.1).empty());
}
