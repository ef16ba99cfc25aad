// The text of the report on a mesh.
#include <catch2/catch.hpp>

#include "sim/mesh/mesh_generate.h"
#include "tests/sim/mesh/checked_mesh.h"

using namespace fascia;
using namespace fascia::test;

TEST_CASE("the unit guess advises a scale that makes the size plausible, and is empty for a plausible size") {
  CHECK(guess_unit(0.25).empty());
  CHECK(guess_unit(0.001).empty());
  CHECK(guess_unit(3).empty());
  const auto contains = [](double extent, const std::string& words) {
    const std::string advice = guess_unit(extent);
    INFO(extent << ": " << advice);
    CHECK(advice.find(words) != std::string::npos);
  };
  contains(6.5, "6.5 m wide");
  contains(6.5, "millimeters? try --set bodies.0.transform.scale=0.001 (6.5 mm wide)");
  contains(6.5, "centimeters? try --set bodies.0.transform.scale=0.01 (65 mm wide)");
  contains(700, "scale=0.001 (700 mm wide)");
  CHECK(guess_unit(700).find("centimeters") == std::string::npos);  // 7 m
  contains(2e5, "scale=1e-06 (200 mm wide)");
  contains(2e-4, "millimeters twice? try --set bodies.0.transform.scale=1000 (200 mm wide)");
  CHECK(guess_unit(100, 1000).find("scale=1 (100 mm wide)") != std::string::npos);  // for a mesh that is already scaled
  contains(1e9, "--set bodies.0.transform.scale=1e-10");
}

TEST_CASE("the report names the findings") {
  TetMesh mesh = make_box(2, 1, 1, {6.5, 1, 1});
  std::swap(mesh.tets[3][0], mesh.tets[3][1]);
  mesh.tets.push_back(mesh.tets[0]);
  for (int k = 0; k < 11; ++k) mesh.tets.push_back({0, 0, 1, 2});
  mesh.regions.assign(mesh.tets.size(), 2);
  mesh.region_names[2] = "tissue";
  mesh.groups["clamp"] = {0, 3, 6};
  mesh.positions.push_back({0, 0, 0});
  const std::string text = report_text(mesh);
  INFO(text);
  const auto has = [&](const std::string& line) { CHECK(text.find(line + "\n") != std::string::npos); };
  has("vertices    13, 1 of them in no usable tet");
  has("tets        24, 12 of them usable");
  has("box         6.5 x 1 x 1 m, from (0, 0, 0) to (6.5, 1, 1)");
  has("volume      6.5 m^3");
  has("components  1");
  has("boundary    20 triangles, manifold");
  has("regions     2  tissue  12 tets, 6.5 m^3");
  has("groups      clamp: 3 vertices");
  has("flipped     1 tet wound inside out, reoriented: 3");
  has("degenerate  11 tets lower than 1e-7 of the longest edge, left out: 13, 14, 15, 16, 17, 18, 19, 20, 21, 22 and 1 "
      "more");
  has("duplicated  1 tet with the vertices of an earlier one, left out: 12");
  CHECK(text.find("\nsize        6.5 m wide, too large for tissue") != std::string::npos);
}

TEST_CASE("the scale that makes a mesh the size of tissue is the likeliest unit's, and 1 where there is none") {
  for (const auto& [extent, scale] :
       {std::pair{0.1, 1.0}, {0.0, 1.0}, {120.0, 1e-3}, {4e5, 1e-6}, {1e-4, 1e3}, {1e-7, 1e6}, {1e12, 1.0}}) {
    CAPTURE(extent, scale);
    CHECK(scale_to_meters(extent) == scale);
  }
}
