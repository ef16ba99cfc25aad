// Sessions that are recorded while they run, and the fate of their files.
#include <sys/resource.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <thread>

#include "app/session/graphics.h"
#include "app/system/user_files.h"
#include "app/video/session_recording.h"
#include "base/error.h"
#include "base/file.h"
#include "sim/mesh/io/mesh_io.h"
#include "sim/mesh/mesh_generate.h"
#include "sim/simulation/simulation.h"
#include "tests/support/headless.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector3d;

namespace {

// A clamped bar that is large enough for a coarse level and for regions at rest.
struct Bar {
  TemporaryFolder folder;
  Scene scene;
  explicit Bar(int nx = 24, int n = 5) {
    write_mesh(folder / "bar.msh", make_box(nx, n, n, {1, 0.2, 0.2}));
    scene.file = folder / "bar.json";
    Body body;
    body.name = "bar";
    body.mesh = "bar.msh";
    body.fixed.push_back(BoxSelection{{-1e-6, -1, -1}, {1e-6, 1, 1}});
    scene.bodies.push_back(body);
  }
};

struct Recorded {
  Graphics graphics = open_graphics(headless(), false);
  Simulation simulation;
  SessionRecording recording;
  Recorded(const Bar& bar, const std::filesystem::path& path)
      : simulation(bar.scene, graphics.programs.get(), false), recording(path, Replay{bar.scene, std::nullopt, {}, 0}) {
    simulation.set_listener([this](const Input& input) { recording.add(input); });
  }
  void steps(int count) {
    for (int i = 0; i < count; ++i) simulation.step();
  }
  void end() { recording.note_state(simulation.steps_made(), state_hash(simulation.state())); }
};

std::vector<GrabSpring> grab(const Model& model, const Vector3d& offset) {
  std::vector<GrabSpring> springs;
  for (std::uint32_t v = 0; v < model.rest_positions.size(); ++v)
    if (model.rest_positions[v].x() > 0.9) springs.push_back({v, Vector3d(0.001 * v, 0, 0) + offset, 500});
  return springs;
}

std::uint64_t replayed_hash(const Replay& replay, Graphics& graphics) {
  Simulation simulation(replay.scene, graphics.programs.get(), false);
  simulation.play(replay);
  for (long i = 0; i < replay.steps; ++i) simulation.step();
  return state_hash(simulation.state());
}

}  // namespace

TEST_CASE(
    "a session of drags, sliders, methods and resets is replayed to the bit, regardless of the timing of background "
    "work",
    "[session]") {
  const Bar bar;
  const std::filesystem::path path = bar.folder / "session.fascia";
  Recorded live(bar, path);
  Simulation& simulation = live.simulation;
  const int pause_ms = GENERATE(0, 2, 30);  // time for the background thread: its results are ready at different steps
  CAPTURE(pause_ms);
  const auto steps = [&](int count) {
    for (int i = 0; i < count; ++i) {
      simulation.step();
      std::this_thread::sleep_for(std::chrono::milliseconds(pause_ms));
    }
  };
  steps(3);
  for (int i = 0; i < 12; ++i) {  // a slider that is dragged while a grab pulls
    Material material = simulation.model.materials[0];
    material.young_modulus *= 0.8;
    simulation.set_material(0, material);
    simulation.set_grab(grab(simulation.model, {0.01 * i, -0.02 * i, 0}));
    steps(1);
  }
  SolverSettings settings = simulation.scene.solver;
  settings.iterations = 4;
  settings.substeps = 2;
  simulation.set_settings(settings);
  steps(9);
  simulation.set_grab({});
  simulation.set_gravity({0, 1, 0});
  steps(5);
  settings.method = Method::vertex_descent;
  settings.acceleration = Acceleration::anderson;
  simulation.set_settings(settings);
  steps(4);
  simulation.reset();
  steps(4);
  settings.method = Method::two_level;
  settings.acceleration = Acceleration::subspace;
  settings.substeps = 1;
  simulation.set_settings(settings);
  Material stiff = simulation.model.materials[0];
  stiff.young_modulus = 4e5;
  simulation.set_material(0, stiff);
  simulation.back_to_valid();
  simulation.begin_anew();
  steps(12);
  live.end();

  const Replay replay = read_replay(path);
  CHECK(replay.steps == simulation.steps_made());
  REQUIRE(replay.hash);
  CHECK(replay.timed);
  std::size_t background = 0;
  for (const Input& input : replay.inputs) background += std::holds_alternative<BackgroundInput>(input.change);
  if (pause_ms == 30) CHECK(background > 0);  // otherwise nothing here depends on timing
  CHECK(hash_text(replayed_hash(replay, live.graphics)) == hash_text(*replay.hash));
  CHECK(hash_text(replayed_hash(replay, live.graphics)) == hash_text(*replay.hash));
}

TEST_CASE("iterations that fitted into a frame budget are replayed", "[session]") {
  Bar bar(10, 3);
  bar.scene.solver.frame_budget = 0.3;
  bar.scene.solver.iterations = 30;
  const std::filesystem::path path = bar.folder / "session.fascia";
  Recorded live(bar, path);
  live.simulation.set_grab(grab(live.simulation.model, {0, 0.1, 0}));
  live.steps(25);
  live.end();
  const Replay replay = read_replay(path);
  CHECK(std::any_of(replay.inputs.begin(), replay.inputs.end(),
                    [](const Input& input) { return std::holds_alternative<GrantInput>(input.change); }));
  CHECK(hash_text(replayed_hash(replay, live.graphics)) == hash_text(*replay.hash));
}

TEST_CASE("a session that sleeps and is woken is replayed", "[session]") {
  Bar bar(6, 2);
  bar.scene.gravity = {0, 0, 0};
  const std::filesystem::path path = bar.folder / "session.fascia";
  Recorded live(bar, path);
  live.steps(100);
  CHECK(live.simulation.asleep());
  live.simulation.set_grab(grab(live.simulation.model, {0, 0.05, 0}));
  live.steps(30);
  live.simulation.set_grab({});
  live.steps(11);
  live.end();
  CHECK(hash_text(replayed_hash(read_replay(path), live.graphics)) == hash_text(*read_replay(path).hash));
}

TEST_CASE("a divergence with its recovery is replayed", "[session]") {
  const Bar bar(6, 2);
  const std::filesystem::path path = bar.folder / "session.fascia";
  Recorded live(bar, path);
  live.steps(21);
  auto torn = grab(live.simulation.model, {1e25, 0, 0});
  for (GrabSpring& spring : torn) spring.stiffness = 1e20;
  live.simulation.set_grab(torn);
  for (int i = 0; i < 60 && !live.simulation.diverged(); ++i) live.steps(1);
  REQUIRE(live.simulation.diverged());
  live.steps(2);  // a window may notice late
  live.simulation.set_grab({});
  live.simulation.back_to_valid();
  live.simulation.begin_anew();
  live.steps(10);
  live.end();
  const Replay replay = read_replay(path);
  Simulation again(replay.scene, live.graphics.programs.get(), false);
  again.play(replay);
  for (long i = 0; i < replay.steps; ++i) {
    again.step();
    REQUIRE_FALSE(again.diverged());  // because it will be restored
  }
  CHECK(hash_text(state_hash(again.state())) == hash_text(*replay.hash));
}

TEST_CASE("a session that ends with a reset or a return to the last valid state is replayed to its end", "[session]") {
  const Bar bar(6, 2);
  const std::filesystem::path path = bar.folder / "session.fascia";
  Recorded live(bar, path);
  live.simulation.set_grab(grab(live.simulation.model, {0, 0.1, 0}));
  const bool torn = GENERATE(false, true);
  live.steps(torn ? 21 : 7);
  if (torn) {
    auto pull = grab(live.simulation.model, {1e25, 0, 0});
    for (GrabSpring& spring : pull) spring.stiffness = 1e20;
    live.simulation.set_grab(pull);
    for (int i = 0; i < 60 && !live.simulation.diverged(); ++i) live.steps(1);
    REQUIRE(live.simulation.diverged());
    live.simulation.set_grab({});
    live.simulation.back_to_valid();
    live.simulation.begin_anew();
  } else {
    live.simulation.set_grab({});
    live.simulation.reset();
  }
  live.end();
  const Replay replay = read_replay(path);
  REQUIRE(replay.inputs.back().step == replay.steps);
  Simulation again(replay.scene, live.graphics.programs.get(), false);
  again.play(replay);
  for (long i = 0; i < replay.steps; ++i) {
    again.step();
    REQUIRE_FALSE(again.diverged());
  }
  CHECK_FALSE(again.check_now());
  CHECK(hash_text(state_hash(again.state())) == hash_text(*replay.hash));
}

TEST_CASE("a recording that begins in mid-session is replayed to the bit", "[session]") {
  const bool within_budget = GENERATE(false, true);
  CAPTURE(within_budget);
  Bar bar;  // with regions at rest, and checks for motion every few steps
  bar.scene.gravity = {0, 0, 0};
  bar.scene.bodies[0].material.damping = 0.3;
  if (within_budget) {
    bar.scene.solver.frame_budget = 3;
    bar.scene.solver.iterations = 30;
  }
  Recorded live(bar, bar.folder / "first.fascia");
  live.simulation.set_grab(grab(live.simulation.model, {0, 0.02, 0}));
  live.steps(13);  // between two checks
  live.simulation.set_grab({});
  Material soft = live.simulation.model.materials[0];
  soft.young_modulus *= 0.5;
  live.simulation.set_material(0, soft);  // the coarse level is updated during the steps
  live.steps(8);
  live.end();
  const long before = live.simulation.steps_made();

  live.simulation.set_listener({});
  const std::filesystem::path path = bar.folder / "second.fascia";
  Replay beginning{live.simulation.scene, std::nullopt, {}, 0};
  beginning.scene.bodies[0].material = soft;
  beginning.start = live.simulation.go_on_as_replay();
  SessionRecording second(path, beginning);
  live.simulation.set_listener([&](const Input& input) { second.add({input.step - before, input.change}); });
  live.steps(40);
  live.simulation.set_grab(grab(live.simulation.model, {0, 0.001, 0}));
  live.steps(9);
  live.simulation.set_grab({});
  live.steps(30);
  second.note_state(live.simulation.steps_made() - before, state_hash(live.simulation.state()));
  const Replay replay = read_replay(path);
  CHECK(replay.steps == 79);
  CHECK(hash_text(replayed_hash(replay, live.graphics)) == hash_text(*replay.hash));
}

TEST_CASE("a session without inputs leaves no file, and an incomplete one is not saved as complete", "[session]") {
  const Bar bar(6, 2);
  const std::filesystem::path path = bar.folder / "session.fascia";
  {
    Recorded idle(bar, path);
    idle.steps(2);
    idle.end();
    CHECK(std::filesystem::exists(path));
    CHECK_THROWS_WITH(idle.recording.save_as(path), Catch::Contains("is where the session is being recorded"));
    CHECK(read_replay(path).steps == 2);
  }
  CHECK_FALSE(std::filesystem::exists(path));

  SessionRecording torn(path, Replay{bar.scene, std::nullopt, {}, 0});
  std::signal(SIGXFSZ, SIG_IGN);  // a limit on file size simulates a full disk
  rlimit usual{};
  getrlimit(RLIMIT_FSIZE, &usual);
  const rlimit full{std::filesystem::file_size(path), usual.rlim_max};
  setrlimit(RLIMIT_FSIZE, &full);
  torn.add({0, GravityInput{{0, 1, 0}}});
  CHECK_THROWS_WITH(torn.note_state(3, 0), Catch::Contains("no longer recorded"));
  setrlimit(RLIMIT_FSIZE, &usual);
  CHECK_THROWS_WITH(torn.save_as(bar.folder / "copy.fascia"), Catch::Contains("recorded in part only"));
  CHECK_FALSE(std::filesystem::exists(bar.folder / "copy.fascia"));
}

TEST_CASE("sessions that other windows record are kept, however many there are", "[session]") {
  const TemporaryFolder home;
  setenv("XDG_STATE_HOME", home.path().c_str(), 1);
  const std::filesystem::path sessions = session_file().parent_path();
  const auto make = [&](const std::string& name) {
    write_file(sessions / (name + ".fascia"), "");
    return sessions / (name + ".fascia");
  };
  const std::filesystem::path live = make("20200101-000000-" + std::to_string(getppid()));
  const std::filesystem::path own = make("20200101-000001-" + std::to_string(getpid()) + "-2"),
                              dead = make("20200101-000002-999999999");
  for (int i = 10; i < 20; ++i) make("20210101-0000" + std::to_string(i) + "-999999999");
  session_file();
  unsetenv("XDG_STATE_HOME");
  CHECK(std::filesystem::exists(live));
  CHECK_FALSE(std::filesystem::exists(own));
  CHECK_FALSE(std::filesystem::exists(dead));
}

TEST_CASE("a replay that is taken over continues, and its own recording is complete", "[session]") {
  const Bar bar(6, 2);
  const std::filesystem::path path = bar.folder / "first.fascia", second_path = bar.folder / "second.fascia";
  Recorded live(bar, path);
  live.simulation.set_grab(grab(live.simulation.model, {0, 0.1, 0}));
  live.steps(12);
  live.end();
  Recorded second(bar, second_path);
  second.simulation.play(read_replay(path));
  CHECK(second.simulation.replaying());
  second.steps(8);
  second.simulation.end_replay();
  CHECK_FALSE(second.simulation.replaying());
  second.simulation.set_grab({});
  second.steps(5);
  second.end();
  CHECK(hash_text(replayed_hash(read_replay(second_path), second.graphics)) ==
        hash_text(*read_replay(second_path).hash));
}

TEST_CASE("ten minutes of dragging take a few megabytes", "[session]") {
  const TemporaryFolder folder;
  Scene scene;
  scene.file = folder / "s.json";
  scene.bodies.emplace_back().mesh = "m.msh";
  SessionRecording recording(folder / "long.fascia", Replay{scene, std::nullopt, {}, 0});
  GrabTrack track;
  constexpr long kSteps = 36000;  // at 60 Hz
  constexpr std::size_t kPatch = 120;
  for (long step = 0; step < kSteps; ++step) {
    std::vector<GrabSpring> springs;
    const Vector3d offset(0.1 * std::sin(0.02 * step), 0.07 * std::cos(0.031 * step), 1e-3 * std::sin(0.5 * step));
    for (std::uint32_t v = 0; v < kPatch; ++v)
      springs.push_back({v, Vector3d(0.01 * v, std::sqrt(v), 0.3) + offset, 1234.5 + v});
    if (const auto move = step % 600 ? track.follow(springs) : std::nullopt) {
      recording.add({step, *move});
    } else {
      track.restart(springs);
      recording.add({step, springs});
    }
    if (step % 4 == 0) recording.look(step, {offset, {0, 0, 1}, {0, 1, 0}, 40}, {});  // the view rotates continuously
  }
  recording.note_state(kSteps, 0);
  const auto bytes = std::filesystem::file_size(folder / "long.fascia");
  CAPTURE(bytes);
  CHECK(bytes < 6'000'000);
  CHECK(read_replay(folder / "long.fascia").steps == kSteps);
}

TEST_CASE("a copy of a session opens at another place", "[session]") {
  const Bar bar(6, 2);
  Recorded live(bar, bar.folder / "session.fascia");
  live.steps(4);
  live.end();
  const TemporaryFolder elsewhere;
  live.recording.save_as(elsewhere / "copy.fascia");
  const Replay copy = read_replay(elsewhere / "copy.fascia");
  CHECK(std::filesystem::equivalent(copy.scene.resolve(copy.scene.bodies[0].mesh), bar.folder / "bar.msh"));
  CHECK(copy.steps == 4);
  CHECK_THROWS_AS(live.recording.save_as(elsewhere / "no" / "copy.fascia"), Error);

  INFO("and is compared with what was recorded");
  const std::vector<std::string> run{"run", "--replay", (elsewhere / "copy.fascia").string(), "--context", "osmesa"};
  CHECK_THAT(run_fascia(run).err, Catch::Contains("fascia: the state is the recorded one to the bit"));
  std::vector<std::string> other = run;
  other.insert(other.end(), {"--set", "gravity=[0,1,0]"});
  CHECK_THAT(run_fascia(other).err, Catch::Contains("the state differs from the recorded one: other values"));
}
