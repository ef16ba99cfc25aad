// Replays as files: written, read back, cut, wrong.
// Covers: replay_write
#include <catch2/catch.hpp>

#include "base/file.h"
#include "sim/replay/replay.h"
#include "tests/sim/scene/scene_test.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector3d;

namespace {

std::string replay_text(const std::string& keys) {
  return R"({"fascia_replay": 1, "scene": )" + scene_text() + ", " + keys + "}";
}

std::string error_of(const std::string& text) {
  const SceneFile file(text, "r.fascia");
  return file.error_of([&] { read_replay(file.path()); });
}

std::string header(const std::string& keys = "") {
  return R"({"fascia_replay": 2, "scene": )" + scene_text() + keys + "}\n";
}

std::string input_error(const std::string& input) {
  return error_of(replay_text(R"("steps": 1, "inputs": [)" + input + "]"));
}

}  // namespace

TEST_CASE("a written replay reads back the same, to the last digit") {
  const SceneFile file(scene_text(R"("materials": {"default": {"young_modulus": 123456.7}})"));
  Replay replay{file.open(), std::nullopt, {}, 77};
  const bool with_start = GENERATE(false, true);
  if (with_start) replay.start = State{{{0.1f, -1e-7f, 3}, {1.0 / 3, 0, -2e8}}, {{1e-30, 5, 6}, {0, 0, 1}}, 0.7};
  SolverSettings settings;
  settings.method = Method::jacobi;
  settings.acceleration = Acceleration::chebyshev;
  settings.iterations = 33;
  Material material;
  material.young_modulus = 2.5e7;
  material.damping = 0.1;
  material.model = MaterialModel::stable_neo_hookean;
  DisplaySettings shown;
  shown.color = ColorBy::strain;
  shown.range = Eigen::Vector2d(0, 0.25);
  shown.wireframe = true;
  replay.inputs = {{0, GrabInput{{3, {0.1, 0.2, -0.3}, 1234.5}, {4, {1, 1, 1}, 2}, {4, {1, 1, 2}, 3, 7}}},
                   {5, settings},
                   {5, MaterialInput{1, material}},
                   {6, GravityInput{{0, 9.81, 0}}},
                   {7, GrabMove{{{1, {0.1, 1.0 / 3, -1e-9}}, {1, {0, 0, 0}}}}},
                   {7, InstrumentInput{"probe", {{0.1, 1.0 / 3, -1e-9}, {12.5, 1.0 / 7, -179}, 2.0 / 3}}},
                   {7, GrantInput{4}},
                   {8, BackgroundInput{2}},
                   {9, ResetInput{true}},
                   {9, ResetInput{false}},
                   {10, RestoreInput{}},
                   {11, CameraSettings{{0.1, 2.0 / 3, 5}, {0, 1e-7, 0}, {0, 0, 1}, 33}},
                   {12, shown},
                   {40, GrabInput{}}};
  if (with_start) replay.start->contact = {{}, {{0.1f, 0, -2}, 5}, {}};
  if (with_start) replay.start->led = {{"forceps", {{0.1, 1.0 / 3, 0}, {0, 90, 1.0 / 7}, 0.3}}};
  if (with_start) replay.start->earlier = {{{0.1f, 0, 3}, {1.0 / 7, 0, -2e8}}, {{1e-30, 4, 6}, {0, 2, 1}}, 1.0 / 60};
  replay.timed = with_start;
  replay.hash = 0x0123456789abcdef;
  replay.made_by = {{"Renderer", "llvmpipe"}, {"Software", "fascia"}};
  write_replay(file / "out.fascia", replay);
  Replay read = read_replay(file / "out.fascia");
  read.scene.file = replay.scene.file;
  CHECK(read.scene == replay.scene);
  CHECK(read.inputs == replay.inputs);
  CHECK(read.steps == 77);
  CHECK(read.timed == replay.timed);
  CHECK(read.hash == replay.hash);
  CHECK(read.made_by == replay.made_by);
  CHECK(read.note == "");
  REQUIRE(read.start.has_value() == with_start);
  if (!with_start) return;
  CHECK(read.start->displacement == replay.start->displacement);
  CHECK(read.start->velocity == replay.start->velocity);
  CHECK(read.start->time == 0.7);
  CHECK(read.start->earlier.displacement == replay.start->earlier.displacement);
  CHECK(read.start->earlier.velocity == replay.start->earlier.velocity);
  CHECK(read.start->earlier.step == 1.0 / 60);
  CHECK(read.start->contact == replay.start->contact);
  CHECK(read.start->led == replay.start->led);
}

TEST_CASE("bodies that an older recording named alike after their files get names of their own") {
  const TemporaryFolder folder;
  const auto names_of = [&](const std::string& second) {
    write_file(folder / "r.fascia", R"({"fascia_replay": 1, "steps": 0, "scene": {"fascia_scene": 1, "bodies": [
      {"name": "m", "mesh": "a/m.msh"}, {"name": ")" +
                                        second + R"(", "mesh": "m.msh"}]}})");
    const Scene scene = read_replay(folder / "r.fascia").scene;
    return scene.bodies[0].name + ", " + scene.bodies[1].name;
  };
  CHECK(names_of("m") == "m, m 2");
  CHECK(names_of("n") == "m, n");
}

TEST_CASE("--set changes the scene of a replay") {
  const SceneFile file(replay_text(R"("steps": 3)"), "r.fascia");
  CHECK(read_replay(file.path(), {"solver.iterations=7"}).scene.solver.iterations == 7);
  CHECK(file.error_of([&] { read_replay(file.path(), {"solver.iterations=0"}); }) ==
        "--set solver.iterations: is 0; expected a whole number, 1 to 10000");
}

TEST_CASE("a file that is no replay is refused in one line") {
  CHECK(error_of("{}") == "r.fascia: fascia_replay: is missing; expected 1 or 2, the version of the format");
  CHECK(error_of(scene_text()) ==
        "r.fascia: bodies: unknown key \"bodies\"; expected one of fascia_replay, scene, steps, start, inputs");
  CHECK(error_of(R"({"fascia_replay": 3})") == "r.fascia: fascia_replay: is 3; expected 1");
  CHECK(error_of(R"({"fascia_replay": 2})") == "r.fascia: scene: is missing; expected the scene that was open");
  CHECK(error_of(R"({"fascia_replay": 1})") == "r.fascia: scene: is missing; expected the scene that was open");
  CHECK(error_of(replay_text(R"("inputs": [])")) == "r.fascia: steps: is missing; expected how many steps to make");
  CHECK(error_of(replay_text(R"("steps": -1)")) == "r.fascia: steps: is -1; expected a whole number, 0 to 1e+09");
  CHECK(error_of(replay_text(R"("steps": 1, "start": {"time": 0, "displacement": [[0, 0, 0]], "velocity": []})")) ==
        "r.fascia: start: 1 displacements, 0 velocities; expected one of each per vertex");
  CHECK(input_error(R"({"step": 1})") ==
        "r.fascia: inputs[0]: is {\"step\":1}; expected \"step\" and one of solver, material, gravity, grab, move, "
        "instrument, iterations, background, reset, sound, camera, display");
  CHECK(
      input_error(R"({"step": 1, "instrument": {"name": "probe", "position": [0, 0, 0], "rotate_deg": [0, 0, 0]}})") ==
      "r.fascia: inputs[0].instrument.grip: is missing; expected 0 to 1");
  CHECK(input_error(R"({"step": 2, "gravity": [0, 0, 0]}, {"step": 1, "gravity": [0, 0, 0]})") ==
        "r.fascia: inputs[1].step: is 1; expected a whole number, 2 to 1e+09");
  CHECK(input_error(R"({"step": 0, "grab": [[1, 2, 3]]})") ==
        "r.fascia: inputs[0].grab[0]: is [1,2,3]; expected a spring [vertex, x, y, z, stiffness, grab]: the "
        "displacement it pulls to [m], N/m, a number if it is not 0");
  CHECK(input_error(R"({"step": 0, "material": {"index": 0, "values": {"young_modulus": -1}}})") ==
        "r.fascia: inputs[0].material.values.young_modulus: is -1; expected 0.001 to 1e+14 Pa");
}

TEST_CASE("a replay of lines is read as far as it was written") {
  const std::string whole = header(R"(, "timed": true)") + R"({"step":0,"gravity":[0,0,1]}
{"step":3,"grab":[[1,0,0,0,5]]}
{"steps":4}
{"step":5,"move":[[1,0.5,0,0]]}
{"steps":9,"hash":"00000000000000ff"}
)";
  const Replay replay = read_replay_content("r.fascia", whole);
  CHECK(replay.timed);
  CHECK(replay.steps == 9);
  CHECK(replay.hash == 0xff);
  REQUIRE(replay.inputs.size() == 3);
  CHECK(std::get<GrabMove>(replay.inputs[2].change).parts.front().offset == Vector3d(0.5, 0, 0));
  // Cut anywhere after the header: never an error, never more than was written, and only the incomplete line is lost.
  const std::size_t first = whole.find('\n') + 1;
  for (std::size_t length = first; length < whole.size(); ++length) {
    CAPTURE(length);
    const std::string cut = whole.substr(0, length);
    const Replay part = read_replay_content("r.fascia", cut);
    const auto lines = std::count(cut.begin() + static_cast<std::ptrdiff_t>(first), cut.end(), '\n');
    CHECK(part.inputs.size() >= std::min<std::size_t>(static_cast<std::size_t>(lines), 2));
    CHECK(part.inputs.size() <= 3);
    const bool torn = cut.back() != '\n' && cut.back() != '}';
    CHECK(part.note.empty() != torn);
  }
  CHECK(read_replay_content("r.fascia", whole.substr(0, whole.find("\n{\"steps\":9") + 1)).steps == 5);
}

TEST_CASE("an error in a line of a replay names the line") {
  CHECK(error_of(header() + "{\"step\":0,\"sound\":true}\n{\"step\":0,\"sound\":false}\n") ==
        "r.fascia:3: sound: is false; expected true");
  CHECK(error_of(header() + "{\"step\":0,\"reset\":\"home\"}\n") ==
        "r.fascia:2: reset: is \"home\"; expected rest or start");
  CHECK(error_of(header() + "{\"step\":1,\"gravity\":[0,0,0]}\n{\"step\":0,\"gravity\":[0,0,0]}\n") ==
        "r.fascia:3: step: is 0; expected a whole number, 1 to 1e+09");
  CHECK(error_of(header() + "{\"steps\":5,\"hash\":\"x\"}\n") ==
        "r.fascia:2: hash: is \"x\"; expected 16 hexadecimal digits");
  CHECK(error_of(header() + "{\"step\":0,\"move\":[[1,2,3]]}\n") ==
        "r.fascia:2: move[0]: is [1,2,3]; expected a part [count, x, y, z]: of the springs, and how far they were led "
        "[m]");
  CHECK(error_of(header() + "{\"step\":0,\"iterations\":0}\n") ==
        "r.fascia:2: iterations: is 0; expected a whole number, 1 to 10000");
  // Only the last line may be incomplete.
  CHECK(error_of(header() + "{\"step\":0,\n{\"steps\":1}\n").starts_with("r.fascia:2:1:"));
}
