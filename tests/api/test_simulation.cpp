// A simulation as programs that use the library see it: steps, states, equilibria, grabs.
// Covers: simulation_grabs, simulation_measure, simulation_state
#include <algorithm>
#include <fstream>

#include "tests/api/api_scenes.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;
using Catch::Contains;

TEST_CASE("Steps are counted, stop on request, and reset returns to the start") {
  Simulation simulation(scene_of(standing_cube()), context());
  CHECK(simulation.step(3) == 3);
  CHECK(simulation.time() == Approx(3.0 / 60));
  CHECK(simulation.positions()[3 * 26 + 1] < 0.1);
  std::stop_source stop;
  stop.request_stop();
  CHECK(simulation.step(3, stop.get_token()) == 0);
  CHECK(simulation.step(0) == 0);
  CHECK(error_of([&] { simulation.step(-1); }) == "step: count: is -1; expected 0 or more");
  CHECK(simulation.time() == Approx(3.0 / 60));
  simulation.reset();
  CHECK(simulation.time() == 0);
  CHECK(std::ranges::equal(simulation.positions(), simulation.rest_positions()));
}

TEST_CASE("Reversed gravity pulls in the opposite direction") {
  Simulation simulation(scene_of(standing_cube()), context());
  CHECK(simulation.gravity() == Vec3{0, -9.81, 0});
  simulation.set_gravity({0, 9.81, 0});
  simulation.step(3);
  CHECK(simulation.positions()[3 * 26 + 1] > 0.1);
  CHECK_THAT(error_of([&] { simulation.set_gravity({0, NAN, 0}); }), Contains("gravity"));
  CHECK(simulation.gravity() == Vec3{0, 9.81, 0});
}

TEST_CASE("Positions and velocities are set at free vertices and read back") {
  Body body = standing_cube();
  Scene scene = scene_of(body);
  scene.gravity = {0, 0, 0};
  Simulation simulation(scene, context());
  std::vector<double> x(simulation.rest_positions().begin(), simulation.rest_positions().end());
  for (std::size_t i = 0; i < x.size(); i += 3) x[i] += 0.25;
  simulation.set_positions(x);
  const std::vector<double> read = simulation.positions();
  std::vector<float> in_float(x.size());
  simulation.read_positions(std::span<float>(in_float));
  for (std::uint32_t v = 0; v < simulation.vertex_count(); ++v) {
    const bool fixed = std::ranges::find(simulation.fixed(), v) != simulation.fixed().end();
    CHECK(read[3 * v] == Approx(x[3 * v] - (fixed ? 0.25 : 0)).margin(1e-8));
    CHECK(in_float[3 * v] == static_cast<float>(read[3 * v]));
  }
  std::vector<double> v(x.size(), 0.5);
  simulation.reset();
  simulation.set_velocities(v);
  CHECK(simulation.velocities()[3 * 26] == 0.5);
  CHECK(simulation.velocities()[3 * body.fixed[0]] == 0);
  v.pop_back();
  CHECK_THAT(error_of([&] { simulation.set_velocities(v); }), Contains("has 80 numbers; expected 81, three a vertex"));
  x[7] = NAN;
  CHECK_THAT(error_of([&] { simulation.set_positions(x); }), Contains("not finite at vertex 2"));
  std::vector<double> small(3);
  CHECK_THAT(error_of([&] { simulation.read_positions(std::span<double>(small)); }), Contains("expected 81"));
}

TEST_CASE("A restored state continues to the same bits") {
  Simulation simulation(scene_of(standing_cube()), context());
  simulation.step(5);
  const State kept = simulation.save();
  simulation.restore(kept);  // data that solvers carry from step to step is reset
  simulation.step(5);
  const std::vector<double> once = simulation.positions();
  simulation.restore(kept);
  CHECK(simulation.time() == kept.time);
  CHECK(simulation.save().displacements == kept.displacements);
  CHECK(simulation.save().velocities == kept.velocities);
  simulation.step(5);
  CHECK(simulation.positions() == once);
  State bad = kept;
  bad.velocities.clear();
  CHECK_THAT(error_of([&] { simulation.restore(bad); }), Contains("restore: velocities"));
}

TEST_CASE("A restored state has the forces of contact, and of bdf2 the substep before") {
  const std::string cube = source_dir() / "assets/scenes/cube.json";
  const std::vector<std::string> on_slope = {"bodies.0.fixed=[]", R"(ground={"height":0,"friction":0.5})",
                                             "gravity=[4,-8.96,0]", "materials.default.damping=0.02",
                                             "materials.default.young_modulus=5e4"};
  for (const char* integrator : {"implicit_euler", "bdf2", "sdirk2"})
    for (const bool slope : {true, false}) {
      OpenOptions options{.set = slope ? on_slope : std::vector<std::string>()};
      options.set.push_back(std::string("solver.integrator=") + integrator);
      Simulation simulation = Simulation::open(cube, context(), options);
      simulation.step(slope ? 90 : 10);  // at rest, and in motion
      const State kept = simulation.save();
      simulation.step(10);
      const std::vector<double> on = simulation.positions();
      const auto off = [&](const State& state) {
        simulation.restore(state);
        simulation.step(10);
        const std::vector<double> again = simulation.positions();
        double farthest = 0;
        for (std::size_t i = 0; i < on.size(); ++i) farthest = std::max(farthest, std::abs(again[i] - on[i]));
        return farthest;
      };
      State alone = kept;
      alone.carried.reset();
      const double with = off(kept), without = off(alone);  // [m] the cube has 0.1 m
      CAPTURE(integrator, slope, with, without);
      if (slope)  // with is 2e-9 at most
        CHECK((without > 1e-3 && with < 1e-3 * without));
      else
        CHECK(with == 0);
    }
}

TEST_CASE("States are written in the format of the extension") {
  const TemporaryFolder folder;
  Simulation simulation(scene_of(standing_cube()), context());
  simulation.step(2);
  for (const char* ending : {".vtu", ".msh", ".obj", ".csv"}) {
    const std::string file = folder / (std::string("state") + ending);
    simulation.write(file);
    CHECK(std::filesystem::file_size(file) > 200);
  }
  const Mesh written = read_mesh(folder / "state.msh");
  const std::vector<double> x = simulation.positions();
  REQUIRE(written.positions.size() == x.size());
  for (std::size_t i = 0; i < x.size(); ++i) CHECK(written.positions[i] == Approx(x[i]));
  CHECK_THAT(error_of([&] { simulation.write(folder / "state.stl"); }), Contains("state.stl"));
}

TEST_CASE("In equilibrium the supports carry the weight, on the GPU and by the reference solver") {
  for (const bool reference : {false, true}) {
    CAPTURE(reference);
    Body column = standing_cube(3);  // no lateral expansion, so that its stress is that of a bar
    column.material = {.young_modulus = 1e5, .poisson_ratio = 0};
    Simulation simulation(scene_of(column), reference ? Context::none() : context(), {.reference = reference});
    int news = 0;
    REQUIRE(simulation.solve_static({}, [&](const StaticReport&) { ++news; }).converged);
    CHECK((reference || news > 0));
    const std::vector<Support> supports = simulation.supports();
    REQUIRE(supports.size() == 1);
    CHECK(supports[0].force[1] == Approx(9.81).epsilon(1e-6));  // of 1 kg
    CHECK(simulation.diagnostics().reaction[1] == Approx(9.81).epsilon(1e-3));
    // The mean stress of a bar of height H under its weight is rho g H / 2. Lumped masses bend it slightly: shear adds
    // a percent.
    const std::vector<double> stress = simulation.von_mises();
    REQUIRE(stress.size() == simulation.tet_count());
    double mean = 0;
    for (const double s : stress) mean += s / static_cast<double>(stress.size());
    CHECK(mean == Approx(1000 * 9.81 * 0.05).epsilon(0.03));
    const TetFields fields = simulation.tet_fields();
    CHECK(fields.green_strain.size() == 6 * simulation.tet_count());
    CHECK(*std::ranges::min_element(fields.det_f) == Approx(simulation.diagnostics().min_det_f).epsilon(1e-4));
    CHECK(simulation.diagnostics().max_von_mises == Approx(*std::ranges::max_element(stress)).epsilon(1e-3));
  }
}

// Without lateral contraction a stretch l has the Cauchy stress E l (l^2 - 1) / 2 everywhere.
TEST_CASE("The stress recovered at the vertices of a drawn cube is that of the closed form") {
  const bool reference = GENERATE(false, true);
  CAPTURE(reference);
  constexpr double kStretch = 1.02, kExact = 1e5 * kStretch * (kStretch * kStretch - 1) / 2;
  Body cube = standing_cube();
  cube.material = {.young_modulus = 1e5, .poisson_ratio = 0, .model = "st_venant_kirchhoff"};
  Simulation simulation(scene_of(cube), reference ? Context::none() : context(), {.reference = reference});
  CHECK(simulation.recovered_stress().max_von_mises < 1e-6 * kExact);
  std::vector<double> drawn(simulation.rest_positions().begin(), simulation.rest_positions().end());
  for (std::size_t v = 0; v < simulation.vertex_count(); ++v) drawn[3 * v + 1] *= kStretch;
  simulation.set_positions(drawn);
  const RecoveredStress stress = simulation.recovered_stress();
  const double digits = reference ? 1e-9 : 1e-4;  // the GPU's positions are float32, of strains of 2 %
  REQUIRE(stress.von_mises.size() == simulation.vertex_count());
  REQUIRE(stress.cauchy.size() == 6 * simulation.vertex_count());
  for (std::size_t v = 0; v < simulation.vertex_count(); ++v) {
    CHECK(stress.von_mises[v] == Approx(kExact).epsilon(digits));
    for (std::size_t k = 0; k < 6; ++k)
      CHECK(stress.cauchy[6 * v + k] == Approx(k == 1 ? kExact : 0).margin(digits * kExact));
  }
  CHECK(stress.max_von_mises == *std::ranges::max_element(stress.von_mises));
  CHECK(stress.p99_von_mises == Approx(kExact).epsilon(digits));
}

TEST_CASE("A search for equilibrium ends when it is stopped, and refuses a falling body") {
  Simulation simulation(scene_of(standing_cube(4)), context());
  std::stop_source stop;
  stop.request_stop();
  CHECK_FALSE(simulation.solve_static(stop.get_token()).converged);
  Body unconstrained = standing_cube();
  unconstrained.fixed.clear();
  Simulation falling(scene_of(unconstrained), context());
  CHECK_FALSE(error_of([&] { falling.solve_static(); }).empty());
}

TEST_CASE("A grab pulls with stiffness times the distance to its target, until it is released") {
  Scene scene = scene_of(standing_cube());
  scene.gravity = {0, 0, 0};
  Simulation simulation(scene, context());
  constexpr std::uint32_t kCorner = 26;
  const Grab grab = simulation.grab_vertex(kCorner, 50);
  CHECK(simulation.stiffness(grab) == Approx(50));
  CHECK(norm(simulation.force(grab)) == 0);
  const Vec3 from = simulation.target(grab);
  CHECK(from == Vec3{0.1, 0.1, 0.1});
  simulation.move(grab, {0.13, 0.1, 0.1});
  CHECK(simulation.force(grab)[0] == Approx(1.5).epsilon(1e-5));  // nothing has moved yet
  REQUIRE(simulation.solve_static().converged);
  const std::vector<double> x = simulation.positions();
  CHECK(x[3 * kCorner] > 0.105);
  CHECK(simulation.force(grab)[0] == Approx(50 * (0.13 - x[3 * kCorner])).epsilon(1e-4));
  CHECK(simulation.diagnostics().grab_force[0] == Approx(simulation.force(grab)[0]).epsilon(1e-3));
  CHECK(simulation.supports()[0].force[0] == Approx(-simulation.force(grab)[0]).epsilon(1e-3));
  simulation.release(grab);
  CHECK(simulation.grabs().empty());
  CHECK_THAT(error_of([&] { simulation.force(grab); }), Contains("grab 0"));
  simulation.solve_static();  // without forces there is no relative residual
  CHECK(simulation.positions()[3 * kCorner] == Approx(0.1).margin(1e-6));
}

TEST_CASE("Several grabs each pull their own vertices, and a patch is moved by its center") {
  Simulation simulation(scene_of(standing_cube(3)), context());
  const Grab left = simulation.grab_patch({0, 0.1, 0.05}, 0.04), right = simulation.grab_patch({0.1, 0.1, 0.05}, 0.04);
  CHECK(simulation.grabs() == std::vector<Grab>{left, right});
  CHECK(simulation.stiffness(left) > 0);
  const Vec3 a = simulation.target(left), b = simulation.target(right);
  simulation.move(left, {a[0] - 0.01, a[1], a[2]});
  simulation.move(right, {b[0] + 0.01, b[1], b[2]});
  REQUIRE(simulation.solve_static().converged);
  CHECK(simulation.force(left)[0] < -0.01);
  CHECK(simulation.force(right)[0] > 0.01);
  CHECK(simulation.force(right)[0] ==
        Approx(-simulation.force(left)[0]).epsilon(0.1));  // a box of tets is not quite symmetric
  const Vec3 all = simulation.diagnostics().grab_force;
  CHECK(all[1] == Approx(simulation.force(left)[1] + simulation.force(right)[1]).epsilon(1e-3));
}

TEST_CASE("Invalid grabs are refused") {
  const Body body = standing_cube();
  Simulation simulation(scene_of(body), context());
  CHECK_THAT(error_of([&] { simulation.grab_vertex(body.fixed[0]); }), Contains("no free vertex"));
  CHECK_THAT(error_of([&] { simulation.grab_vertex(27); }), Contains("names vertex 27"));
  CHECK_THAT(error_of([&] { simulation.grab_vertex(26, -1); }), Contains("stiffness"));
  CHECK_THAT(error_of([&] { simulation.grab_patch({0, 0, 0}, 0); }), Contains("radius"));
  CHECK(simulation.grabs().empty());
}

TEST_CASE("A diverged state is reported, and an earlier one can be restored") {
  Simulation simulation(scene_of(standing_cube()), context());
  simulation.step(2);
  CHECK_FALSE(simulation.diverged_vertex());
  std::vector<double> v(3 * simulation.vertex_count(), 1e30);
  simulation.set_velocities(v);
  simulation.step(3);
  REQUIRE(simulation.diverged_vertex());
  simulation.reset();
  CHECK_FALSE(simulation.diverged_vertex());
}

TEST_CASE("A moved simulation object continues") {
  Simulation a(scene_of(standing_cube()), context());
  a.step();
  Simulation b = std::move(a);
  b.step();
  CHECK(b.time() == Approx(2.0 / 60));
  b = Simulation(scene_of(standing_cube()), context());
  CHECK(b.time() == 0);
}
