// Instruments that a hand leads: their replays give the same bits, jaws included, and resets put them back on their
// paths.
// Covers: simulation_replay
#include <catch2/catch.hpp>

#include "app/session/graphics.h"
#include "sim/mesh/io/mesh_io.h"
#include "sim/mesh/mesh_generate.h"
#include "sim/simulation/simulation.h"
#include "tests/support/headless.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector3d;

namespace {

constexpr double kSide = 0.1, kRadius = 0.02;

// A soft cube on its base, a ball on a path above it, and open jaws around it.
struct Bench {
  TemporaryFolder folder;
  Graphics graphics = open_graphics(headless(), false);
  Scene scene;
  Bench() {
    write_mesh(folder / "box.msh", make_box(3, 3, 3, {kSide, kSide, kSide}));
    scene.file = folder / "box.json";
    Body body;
    body.name = "box";
    body.mesh = (folder / "box.msh").string();
    body.material.young_modulus = 2e4;
    body.material.damping = 0.02;
    body.fixed.push_back(BoxSelection{{-1, -1e-6, -1}, {1, 1e-6, 1}});
    scene.bodies.push_back(body);
    const Vector3d above(kSide / 2, kSide + kRadius + 0.01, kSide / 2);
    scene.tools.instruments.push_back({"ball",
                                       ToolShape(SphereShape{{0, 0, 0}, kRadius}),
                                       std::nullopt,
                                       {{0, above, {0, 0, 0}, 0}, {2, above + Vector3d(0, 0.1, 0), {0, 0, 0}, 0}},
                                       false});
    scene.tools.instruments.push_back({"forceps",
                                       JawsShape{BoxShape{{0.03, -0.1, 0}, {0.01, 0.1, 0.02}, 0.005}, {0, 0, 1}, 60},
                                       0.8,
                                       {{0, {kSide / 2, 0.26, kSide / 2}, {0, 0, 0}, 0}},
                                       false});
  }
  std::unique_ptr<Simulation> open(bool reference = false) {
    return std::make_unique<Simulation>(scene, graphics.programs.get(), reference);
  }
};

// As a hand does: the ball goes down with a turn, and from step 5 on the jaws close.
void drive(Simulation& simulation, int steps) {
  for (int i = 0; i < steps; ++i) {
    const double down = 0.0013 * i;
    simulation.lead(
        {"ball", {{kSide / 2 + 0.3 * down, kSide + kRadius + 0.01 - down, kSide / 2}, {0, 1.0 / 3 * i, 0}, 0}});
    const double grip = std::min(1.0, 1.0 / 33 * (i - 4));
    if (i >= 5) simulation.lead({"forceps", {{kSide / 2, 0.26, kSide / 2}, {0, 0, 0.1 * i}, grip}});
    simulation.step();
  }
}

std::vector<ToolLoad> loads_of(Simulation& simulation) {
  simulation.gpu()->request_diagnostics();
  return simulation.gpu()->take_diagnostics(true)->tool_loads;
}

void check_same(const State& a, const State& b) {
  CHECK(state_hash(a) == state_hash(b));
  CHECK(a.contact == b.contact);
  CHECK(a.led == b.led);
}

}  // namespace

TEST_CASE("a replay repeats led instruments to the bit, jaws included, also through a file and a reset", "[contact]") {
  Bench bench;
  const auto simulation = bench.open();
  Replay replay{simulation->scene, std::nullopt, {}, 0};
  simulation->set_listener([&](const Input& input) { replay.inputs.push_back(input); });
  for (int i = 0; i < 3; ++i) simulation->step();  // on their paths
  drive(*simulation, 12);
  simulation->reset();
  CHECK(simulation->led_tools().empty());
  CHECK(simulation->tool_places() == places_at(simulation->model.tools, 0));
  drive(*simulation, 30);
  const std::vector<ToolLoad> loads = loads_of(*simulation);
  INFO("ball " << loads[0].force.transpose() << " N, forceps " << loads[1].force.transpose() << " N with "
               << loads[1].points << " points");
  CHECK(loads[0].force.y() < -0.1);
  CHECK(loads[1].points > 4);
  replay.steps = simulation->steps_made();
  const State end = simulation->state();
  CHECK(end.led.size() == 2);

  write_replay(bench.folder / "hand.fascia", replay);
  const Replay read = read_replay(bench.folder / "hand.fascia");
  CHECK(read.inputs == replay.inputs);
  const auto again = bench.open();
  again->play(read);
  while (again->replaying()) again->step();
  check_same(again->state(), end);
  const std::vector<ToolLoad> loads_again = loads_of(*again);
  for (std::size_t t = 0; t < loads.size(); ++t) {
    CHECK(loads_again[t].force == loads[t].force);
    CHECK(loads_again[t].torque == loads[t].torque);
  }
}

TEST_CASE("a replay that begins while instruments are led has their places", "[contact]") {
  Bench bench;
  const auto simulation = bench.open();
  drive(*simulation, 20);
  Replay replay{simulation->scene, simulation->go_on_as_replay(), {}, 0};
  simulation->set_listener([&](const Input& input) { replay.inputs.push_back({input.step - 20, input.change}); });
  simulation->step();  // both stay where they are
  drive(*simulation, 15);
  replay.steps = simulation->steps_made() - 20;
  write_replay(bench.folder / "hand.fascia", replay);
  const auto again = bench.open();
  again->play(read_replay(bench.folder / "hand.fascia"));
  CHECK(again->led_tools() == replay.start->led);
  while (again->replaying()) again->step();
  check_same(again->state(), simulation->state());
}

TEST_CASE("steps in contact give the same bits with single kernels and with fused ones", "[contact]") {
  Bench bench;
  std::vector<State> states;
  for (const bool fusing : {true, false}) {
    bench.graphics.programs->set_fusing(fusing);
    const auto simulation = bench.open();
    drive(*simulation, 30);
    states.push_back(simulation->state());
  }
  check_same(states[0], states[1]);
}

TEST_CASE("a replay that leads what is no instrument is refused", "[contact]") {
  Bench bench;
  const auto simulation = bench.open();
  Replay replay{simulation->scene, std::nullopt, {{0, InstrumentInput{"hook", {}}}}, 1};
  CHECK_THROWS_WITH(simulation->play(replay),
                    Catch::Contains("an input leads hook; expected an instrument of the scene"));
}

TEST_CASE("a led instrument wakes tissue that sleeps, and one at rest lets it sleep", "[contact]") {
  Bench bench;
  bench.scene.gravity.setZero();
  bench.scene.tools.instruments[0].path.resize(1);
  const auto simulation = bench.open();
  constexpr long kMost = 3000;
  const auto sleep = [&] {
    for (long i = 0; i < kMost && !simulation->asleep(); ++i) simulation->step();
    return simulation->asleep();
  };
  REQUIRE(sleep());
  const LedTool up{"ball", {{kSide / 2, 0.2, kSide / 2}, {0, 0, 0}, 0}};
  simulation->lead(up);
  simulation->step();
  CHECK_FALSE(simulation->asleep());
  CHECK(sleep());
  simulation->lead(up);  // where it is
  CHECK(simulation->asleep());
}

TEST_CASE("the reference solver takes led instruments, and their paths again after a reset", "[contact]") {
  Bench bench;
  const auto exact = bench.open(true), fast = bench.open();
  for (Simulation* simulation : {exact.get(), fast.get()}) drive(*simulation, 24);
  const double force = exact->newton_tool_loads()[0].force.y(), on_gpu = loads_of(*fast)[0].force.y();
  INFO("force of the ball " << force << " N, on the GPU " << on_gpu << " N");
  CHECK(force < -0.1);
  CHECK(on_gpu == Approx(force).epsilon(0.05));
  exact->reset();
  exact->step();
  CHECK(exact->newton_tool_loads()[0].points == 0);
}
