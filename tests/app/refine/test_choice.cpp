#include "app/refine/choice.h"

#include <catch2/catch.hpp>

#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;
using Catch::Matchers::VectorContains;

namespace {

Scene scene_with(std::vector<std::optional<int>> resolutions) {
  Scene scene;
  for (const std::optional<int>& resolution : resolutions) scene.bodies.emplace_back().resolution = resolution;
  return scene;
}

Proposal finer(double refinement) {
  Proposal proposal;
  proposal.elements = ElementOrder::quadratic;
  proposal.integrator = Integrator::bdf2;
  proposal.refinement = refinement;
  proposal.substeps = 2;
  proposal.iterations = 7;
  return proposal;
}

}  // namespace

TEST_CASE("the options of a choice address every body", "[refine]") {
  const Scene scene = scene_with({10, std::nullopt, 7});
  CHECK(sets_of(finer(2), scene) == std::vector<std::string>{"elements=quadratic", "bodies.1.elements=quadratic",
                                                             "bodies.2.elements=quadratic", "solver.integrator=bdf2",
                                                             "solver.substeps=2", "solver.iterations=7",
                                                             "resolution=20", "bodies.2.resolution=14"});
}

TEST_CASE("a scene opened with the options of a choice has it", "[refine]") {
  const std::filesystem::path file = source_dir() / "assets/scenes/organs.json";
  const Scene before = open_scene(file), after = open_scene(file, sets_of(finer(1.5), before));
  CHECK(has_resolution(before));
  CHECK_FALSE(has_resolution(open_scene(cube_path())));
  REQUIRE(after.bodies.size() == 2);
  for (const Body& body : after.bodies) CHECK(body.elements == ElementOrder::quadratic);
  CHECK_FALSE(after.bodies[0].resolution);
  CHECK(after.bodies[1].resolution == 21);
  CHECK(after.solver.integrator == Integrator::bdf2);
  CHECK(after.solver.substeps == 2);
  CHECK(after.solver.iterations == 7);
  CHECK(after.solver.method == before.solver.method);
}

TEST_CASE("meshes to choose from are whole numbers of cells within the limits of a resolution", "[refine]") {
  const std::vector<double> of_ten = refinements_of(scene_with({10}));
  CHECK_THAT(of_ten, VectorContains(1.0) && VectorContains(2.0) && VectorContains(1.3));
  for (const double refinement : of_ten) CHECK(10 * refinement == Approx(std::lround(10 * refinement)));
  CHECK(refinements_of(scene_with({2})).front() == 1);
  CHECK(refinements_of(scene_with({128})).back() == 2);
  CHECK(refinements_of(scene_with({10, 64})).back() == 4);
  CHECK(refinements_of(scene_with({std::nullopt, 128})).back() == 2);
  CHECK(refinements_of(scene_with({std::nullopt})) == usual_refinements());
}
