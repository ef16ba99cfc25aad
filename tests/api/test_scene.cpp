#include <thread>

#include "tests/api/api_scenes.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;
using Catch::Contains;

namespace {

std::string refusal(const Body& body) {
  return error_of([&] { Simulation(scene_of(body), context()); });
}

}  // namespace

TEST_CASE("Arrays of inconsistent sizes are refused") {
  const Body good = standing_cube();
  REQUIRE(refusal(good).empty());
  Body bad = good;
  bad.mesh.positions.pop_back();
  CHECK_THAT(refusal(bad), Contains("bodies[0].mesh.positions"));
  bad = good;
  bad.mesh.tets.push_back(0);
  CHECK_THAT(refusal(bad), Contains("bodies[0].mesh.tets"));
  bad = good;
  bad.mesh.tets[9] = 27;
  CHECK_THAT(refusal(bad), Contains("names vertex 27 in tet 2; expected an index below 27"));
  bad = good;
  bad.mesh.regions = {1, 2};
  CHECK_THAT(refusal(bad), Contains("regions"));
  bad = good;
  bad.mesh.positions[4] = INFINITY;
  CHECK_THAT(refusal(bad), Contains("not finite at vertex 1"));
  bad = good;
  bad.fixed = {27};
  CHECK_THAT(refusal(bad), Contains("bodies[0].fixed: names vertex 27"));
  bad = good;
  bad.region_materials[3] = {};
  CHECK_THAT(refusal(bad), Contains("3"));
  bad = good;
  bad.elements = "cubic";
  CHECK_THAT(refusal(bad), Contains("bodies[0].elements: is \"cubic\"; expected linear or quadratic"));
  bad = good;
  bad.initial_velocity = {1, 2, 3};
  CHECK_THAT(refusal(bad), Contains("initial_velocity"));
  bad = good;
  for (double& x : bad.mesh.positions) x = 0;
  CHECK_THAT(refusal(bad), Contains("no tet"));
  CHECK_THAT(error_of([] { Simulation(Scene(), context()); }), Contains("no bodies"));
  CHECK_THAT(error_of([&] { Simulation(scene_of(good), context(), {.set = {"solver.iterations=3"}}); }),
             Contains("OpenOptions::set"));
}

TEST_CASE("A body of quadratic tets has a vertex in the middle of every edge, and they move with it") {
  Body body = standing_cube();
  const std::size_t corners = body.mesh.vertex_count();
  body.elements = "quadratic";
  Scene scene = scene_of(body);
  scene.settings.integrator = "bdf2";
  Simulation simulation(scene, context());
  CHECK(simulation.tet_count() == body.mesh.tet_count());
  REQUIRE(simulation.vertex_count() == 125);  // 3 x 3 x 3 corners of cells in six tets each: their half lattice
  const std::vector<double> before = simulation.positions();
  simulation.step(10);
  const std::vector<double> after = simulation.positions();
  double middles = 0;
  for (std::size_t k = 3 * corners; k < after.size(); ++k) middles = std::max(middles, std::abs(after[k] - before[k]));
  CHECK(middles > 1e-4);
  scene.settings.method = "jacobi";
  scene.settings.acceleration = "none";
  CHECK_THAT(error_of([&] { Simulation(scene, context()); }), Contains("does not carry quadratic elements"));
}

TEST_CASE("Tets of either winding are accepted, and repairs are noted") {
  Body body = standing_cube();
  std::swap(body.mesh.tets[0], body.mesh.tets[1]);
  const Simulation simulation(scene_of(body), context());
  CHECK(simulation.tet_count() == body.mesh.tet_count());
  REQUIRE_FALSE(simulation.notes().empty());
  CHECK_THAT(simulation.notes().front(), Contains("1 tet flipped"));
}

TEST_CASE("Bodies keep their order, regions have materials of their own") {
  Scene scene = scene_of(standing_cube());
  scene.bodies[0].mesh.regions.assign(scene.bodies[0].mesh.tet_count(), 0);
  for (std::size_t t = 0; t < 10; ++t) scene.bodies[0].mesh.regions[t] = 4;
  scene.bodies[0].region_materials[4] = {.young_modulus = 3e4,
                                         .poisson_ratio = 0.2,
                                         .density = 2000,
                                         .damping = 0.01,
                                         .model = "mooney_rivlin",
                                         .mooney_ratio = 0.7};
  Body second = standing_cube(1);
  second.name = "second";
  for (std::size_t i = 0; i < second.mesh.positions.size(); i += 3) second.mesh.positions[i] += 1;
  scene.bodies.push_back(second);
  Simulation simulation(scene, context());
  const std::vector<BodyRange> bodies = simulation.bodies();
  REQUIRE(bodies.size() == 2);
  CHECK(bodies[1].name == "second");
  CHECK(bodies[1].vertex_begin == 27);
  CHECK(bodies[1].vertex_count == 8);
  REQUIRE(simulation.material_count() == 3);
  CHECK(simulation.material_name(1) == "cube: 4");
  const Material& region = simulation.material(1);
  CAPTURE(region.model, region.young_modulus, region.poisson_ratio, region.density, region.damping,
          region.mooney_ratio);
  CHECK(region.young_modulus == 3e4);
  CHECK(region.poisson_ratio == 0.2);
  CHECK(region.density == 2000);
  CHECK(region.damping == 0.01);
  CHECK(region.model == "mooney_rivlin");
  CHECK(region.mooney_ratio == 0.7);
  CHECK(simulation.fixed().size() == 9 + 4);
  double mass = 0;
  for (const double m : simulation.masses()) mass += m;
  CHECK(mass == Approx(1 + 10.0 / 48 + 1));  // ten of 48 tets of 1/48 liter have twice the density
}

TEST_CASE("Prescribed vertices arrive where their motion ends, and initial velocities are those of free vertices") {
  Body body = standing_cube();
  Motion motion;
  for (std::uint32_t v = 0; v < body.mesh.vertex_count(); ++v)
    if (body.mesh.positions[3 * v + 1] == 0.1) motion.vertices.push_back(v);
  motion.translate = {0.02, 0, 0};
  motion.duration = 0.1;
  body.motions.push_back(motion);
  for (std::size_t v = 0; v < body.mesh.vertex_count(); ++v)
    body.initial_velocity.insert(body.initial_velocity.end(), {0, 0, 0.5});
  Simulation simulation(scene_of(body), context());
  const std::vector<double> velocity = simulation.velocities();
  CHECK(velocity[3 * body.fixed[0] + 2] == 0);
  CHECK(velocity[3 * 12 + 2] == 0.5);  // in the middle layer
  simulation.step(10);
  const std::vector<double> x = simulation.positions();
  for (const std::uint32_t v : motion.vertices)
    CHECK(x[3 * v] == Approx(body.mesh.positions[3 * v] + 0.02).margin(1e-7));
  CHECK(simulation.supports().size() == 2);
  CHECK(simulation.supports()[1].motion == std::size_t(0));
  body.motions.push_back(motion);
  CHECK_THAT(refusal(body), Contains("expected each vertex in one motion"));
}

TEST_CASE("A scene file is opened with keys replaced, and reports its progress") {
  const std::string file = source_dir() / "assets/scenes/cube.json";
  std::vector<double> shares;
  OpenOptions options{.set = {"solver.iterations=3"}};
  options.control.progress = [&](double share, const char*) { shares.push_back(share); };
  Simulation simulation = Simulation::open(file, context(), options);
  CHECK(simulation.settings().iterations == 3);
  CHECK_FALSE(shares.empty());
  CHECK(std::is_sorted(shares.begin(), shares.end()));
  CHECK_THAT(error_of([&] { Simulation::open(file, context(), {.set = {"solver.iteration=3"}}); }),
             Contains("iterations"));
  CHECK_THAT(error_of([&] { Simulation::open("/nowhere.json", context()); }), Contains("/nowhere.json"));
  std::stop_source stop;
  stop.request_stop();
  options.control.stop = stop.get_token();
  CHECK_THROWS_AS(Simulation::open(file, context(), options), Interrupted);
}
