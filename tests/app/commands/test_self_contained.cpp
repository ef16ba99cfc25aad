// Scenes and replays that carry their meshes, through the program: made by a command, by a session, and by a
// divergence.
#include <catch2/catch.hpp>

#include "app/session/graphics.h"
#include "app/video/session_recording.h"
#include "base/error.h"
#include "base/file.h"
#include "sim/grab/build_model.h"
#include "sim/mesh/io/mesh_io.h"
#include "sim/mesh/mesh_generate.h"
#include "sim/scene/scene_carry.h"
#include "sim/simulation/divergence.h"
#include "tests/support/headless.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

std::string hash_of(const std::string& file, const fs::path& folder) {
  const CommandResult run =
      run_fascia({"run", file, "--context", "osmesa", "--steps", "3", "--hash", "--quiet"}, folder);
  CAPTURE(run.err);
  CHECK(run.exit_code == 0);
  CHECK(run.out.size() > 20);
  return run.out;
}

struct Bar {
  TemporaryFolder folder;
  Scene scene;
  Bar() {
    write_mesh(folder / "bar.msh", make_box(4, 2, 2, {0.4, 0.2, 0.2}));
    write_file(
        folder / "bar.json",
        R"({"fascia_scene": 1, "bodies": [{"mesh": "bar.msh", "fixed": [{"box": [[-1, -1, -1], [0.001, 1, 1]]}]}]})");
    scene = open_scene(folder / "bar.json");
  }
};

}  // namespace

TEST_CASE("convert --with-mesh makes scenes and replays that open from an empty folder", "[self_contained]") {
  const Bar bar;
  Replay replay{bar.scene, std::nullopt, {{1, GravityInput{{0, 3, 0}}}}, 3};
  write_replay(bar.folder / "bar.fascia", replay);
  const TemporaryFolder elsewhere;
  const std::string scene = (elsewhere / "moved.json").string(), moved = (elsewhere / "moved.fascia").string();
  for (const auto& [in, out] : {std::pair{"bar.json", scene}, std::pair{"bar.fascia", moved},
                                std::pair{"bar.msh", (elsewhere / "mesh.json").string()}}) {
    const std::string before = hash_of(in, bar.folder.path());
    const CommandResult made = run_fascia({"convert", in, out, "--with-mesh"}, bar.folder.path());
    CHECK(made.exit_code == 0);
    CHECK_THAT(made.err, Contains("with bar.msh"));
    fs::rename(bar.folder / "bar.msh", bar.folder / "away");
    CHECK(hash_of(out, elsewhere.path()) == before);
    fs::rename(bar.folder / "away", bar.folder / "bar.msh");
  }
  CHECK_THAT(run_fascia({"info", moved}).out, Contains("Carries") && Contains("bar.msh"));
  CHECK_THAT(run_fascia({"info", scene}).out, Contains("moved.json/bar.msh"));

  INFO("without the option, and with the wrong ending");
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{"convert", "bar.json", scene},
                                                    {"convert", "bar.fascia", moved},
                                                    {"convert", "bar.json", moved, "--with-mesh"},
                                                    {"convert", "bar.json", "bar.json", "--with-mesh"}}) {
    const CommandResult refused = run_fascia(arguments, bar.folder.path());
    CAPTURE(refused.err);
    CHECK(refused.exit_code == 2);
    CHECK(std::count(refused.err.begin(), refused.err.end(), '\n') == 1);
  }
}

TEST_CASE("a moved replay without its mesh reports itself, the key and the places searched", "[self_contained]") {
  const Bar bar;
  write_replay(bar.folder / "bar.fascia", Replay{bar.scene, std::nullopt, {}, 3});
  const TemporaryFolder elsewhere;
  fs::copy_file(bar.folder / "bar.fascia", elsewhere / "bar.fascia");
  const CommandResult run = run_fascia({"run", "--replay", "bar.fascia", "--context", "osmesa"}, elsewhere.path());
  CHECK(run.exit_code == 1);
  CHECK_THAT(run.err, Contains("bar.fascia: bodies[0].mesh: bar.msh: no such file; looked in "));
}

TEST_CASE("a recording's mesh that is found at another place must be the recorded one", "[self_contained]") {
  const Bar bar;
  Replay replay{bar.scene, std::nullopt, {}, 3};
  replay.scene.bodies[0].mesh = "gone/bar.msh";
  replay.made_by = {{"Mesh hash", hash_text(mesh_hash(build_model(bar.scene).file_mesh))}};
  write_replay(bar.folder / "bar.fascia", replay);
  const std::vector<std::string> run{"run", "--replay", "bar.fascia", "--context", "osmesa"};
  CHECK_THAT(run_fascia(run, bar.folder.path()).err, Contains("gone/bar.msh: no such file; read "));
  write_mesh(bar.folder / "bar.msh", make_box(4, 2, 2, {0.4, 0.3, 0.2}));
  const CommandResult refused = run_fascia(run, bar.folder.path());
  CHECK(refused.exit_code == 1);
  CHECK_THAT(refused.err,
             Contains("bar.fascia: bodies[0].mesh: ") && Contains("the mesh differs from the recorded one"));
}

TEST_CASE("a replay of a diverged state carries its mesh", "[self_contained]") {
  const Bar bar;
  Replay broken{bar.scene, initial_state(build_model(bar.scene)), {}, 30};
  broken.start->displacement[40] = {1e25, 0, 0};
  write_replay(bar.folder / "broken.fascia", broken);
  const CommandResult run = run_fascia({"run", "--replay", "broken.fascia", "--context", "osmesa"}, bar.folder.path());
  const std::size_t named = run.err.find("repeated by ");
  CAPTURE(run.err);
  REQUIRE(named != std::string::npos);
  const std::string replay = run.err.substr(named + 12, run.err.find(';', named) - named - 12);
  const TemporaryFolder elsewhere;
  fs::copy_file(bar.folder / replay, elsewhere / replay);
  fs::remove(bar.folder / "bar.msh");
  const CommandResult again = run_fascia({"run", "--replay", replay, "--context", "osmesa"}, elsewhere.path());
  CHECK(again.exit_code == 1);
  CHECK_THAT(again.err, Contains("diverged at "));
}

TEST_CASE("a session carries its mesh from the start, or else from when it is saved", "[self_contained]") {
  const Bar bar;
  for (const bool from_the_start : {true, false}) {
    CAPTURE(from_the_start);
    Model model = build_model(bar.scene);
    const TemporaryFolder elsewhere;
    const Scene scene = from_the_start ? self_contained_if_possible(bar.scene, model.files)
                                       : self_contained_if_possible(bar.scene, model.files, 100);
    CHECK(scene.carries("bar.msh") == from_the_start);
    SessionRecording recording(elsewhere / "session.fascia", Replay{scene, std::nullopt, {}, 0});
    recording.add({0, GravityInput{{0, 1, 0}}});
    recording.note_state(2, 0);
    CHECK(read_replay(elsewhere / "session.fascia").scene.carries("bar.msh") == from_the_start);
    CHECK(recording.carry_files(model.files));
    recording.save_as(elsewhere / "saved.fascia");
    fs::rename(bar.folder / "bar.msh", bar.folder / "away");
    const Replay saved = read_replay(elsewhere / "saved.fascia");
    CHECK(saved.steps == 2);
    CHECK(mesh_hash(build_model(saved.scene).file_mesh) == mesh_hash(model.file_mesh));
    fs::rename(bar.folder / "away", bar.folder / "bar.msh");
  }
}
