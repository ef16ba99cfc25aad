#include "tests/api/api_scenes.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;
using Catch::Contains;

TEST_CASE("Separate contexts of both kinds work side by side, in any order of calls") {
  Simulation a(scene_of(standing_cube()), Context::own("osmesa"));
  Simulation b(scene_of(standing_cube()), Context::own("egl"));
  CHECK(a.context().kind() == "osmesa");
  CHECK(b.context().kind() == "egl");
  CHECK_FALSE(a.context().renderer().empty());
  for (int i = 0; i < 4; ++i) {
    a.step();
    b.step();
  }
  const std::vector<double> xa = a.positions(), xb = b.positions();
  for (std::size_t i = 0; i < xa.size(); ++i) CHECK(xa[i] == Approx(xb[i]).margin(1e-6));
  CHECK(xa[xa.size() - 2] < 0.1 - 1e-4);
}

TEST_CASE("A context exists as long as a simulation needs it, after its handle is gone") {
  auto simulation = [] {
    const Context local = Context::own("osmesa");
    return Simulation(scene_of(standing_cube()), local);
  }();
  simulation.step();
  CHECK(simulation.time() == Approx(1.0 / 60));
}

TEST_CASE("The current context is found without an argument that names it") {
  const Context own = Context::own("osmesa");
  Simulation in_own(scene_of(standing_cube()), own);
  in_own.step();  // makes it current
  const Context found = Context::current();
  CHECK(found.kind() == "current");
  CHECK(found.renderer() == own.renderer());
  Simulation in_found(scene_of(standing_cube()), found);
  in_found.step();
  CHECK(in_found.positions() == in_own.positions());

  Simulation in_other(scene_of(standing_cube()), Context::own("osmesa"));
  in_other.step();  // which is current at this point
  CHECK_THAT(error_of([&] { in_found.step(); }), Contains("is not current"));
  in_own.step();
  in_found.step();
  CHECK(in_found.positions() == in_own.positions());
}

TEST_CASE("Without a context only the reference solver computes") {
  CHECK(Context::none().renderer().empty());
  CHECK_THAT(error_of([] { Simulation(scene_of(standing_cube()), Context::none()); }), Contains("none()"));
  Simulation simulation(scene_of(standing_cube()), Context::none(), {.reference = true});
  simulation.step();
  CHECK(simulation.diagnostics().residual < 1e-9);
  CHECK_THAT(error_of([&] { simulation.position_buffer(); }), Contains("no GPU"));
}

TEST_CASE("Unknown kinds of contexts and folders without shaders are refused") {
  CHECK_THAT(error_of([] { Context::own("vulkan"); }), Contains("vulkan"));
  const TemporaryFolder folder;
  CHECK_THAT(error_of([&] { set_data_dir(folder.path()); }), Contains("no folder shaders"));
  CHECK_FALSE(data_dir().empty());
}
