// The recording of an open session: its begin and end, and the messages about a replay.
#include <catch2/catch.hpp>
#include <cstdlib>

#include "app/window/recording_control.h"
#include "tests/support/headless_stage.h"

using namespace fascia;
using namespace fascia::test;

namespace {

/// With its own folder for recordings.
struct RecordingDesk : HeadlessStage {
  TemporaryFolder folder;
  const char* before = std::getenv("XDG_STATE_HOME");
  std::string kept = before ? before : "";
  RecordingControl recording{stage, sides, true};

  RecordingDesk() { setenv("XDG_STATE_HOME", folder.path().c_str(), 1); }
  ~RecordingDesk() {
    if (before)
      setenv("XDG_STATE_HOME", kept.c_str(), 1);
    else
      unsetenv("XDG_STATE_HOME");
  }
  Replay saved() {
    recording.save(folder / "saved.fascia");
    return read_replay(folder / "saved.fascia");
  }
  void turn(int iterations) { set_iterations(*stage.session, iterations); }
};

}  // namespace

TEST_CASE("a recording has the inputs since the session was opened, with the state at its end") {
  RecordingDesk desk;
  desk.recording.session_began();
  desk.sides.step();
  desk.turn(7);
  desk.sides.step();
  desk.recording.follow();
  const Replay replay = desk.saved();
  CHECK(replay.steps == 2);
  CHECK_FALSE(replay.start);
  CHECK(replay.hash == state_hash(desk.stage.simulation().state()));
  CHECK(std::any_of(replay.inputs.begin(), replay.inputs.end(), [](const Input& input) {
    const auto* settings = std::get_if<SolverSettings>(&input.change);
    return settings && settings->iterations == 7 && input.step == 1;
  }));
  CHECK_THAT(desk.stage.messages.text(), Catch::Contains("Saved"));
}

TEST_CASE("a change to another session ends the recording, and the next one begins in mid-session until a reset") {
  RecordingDesk desk;
  desk.recording.session_began();
  for (int i = 0; i < 3; ++i) desk.sides.step();
  bool changed = false;
  desk.recording.begin_anew_around([&] { changed = true; });
  CHECK(changed);
  desk.turn(7);
  desk.sides.step();
  const Replay middle = desk.saved();
  REQUIRE(middle.start);
  CHECK(middle.start->time > 0);
  CHECK(middle.steps == 1);

  INFO("where the session has a start of its own, the reset leads away from the recording's");
  desk.stage.simulation().set_start(initial_state(desk.stage.simulation().model));
  desk.recording.reset_around([&] { desk.sides.reset(); });
  desk.turn(8);
  desk.sides.step();
  const Replay anew = desk.saved();
  CHECK(anew.steps == 1);
  CHECK((!anew.start || anew.start->time == 0));
}

TEST_CASE("a session that is not recorded cannot be saved") {
  HeadlessStage desk;
  RecordingControl recording(desk.stage, desk.sides, false);
  recording.session_began();
  recording.follow();
  recording.end();
  CHECK_THROWS_WITH(recording.save("never.fascia"), Catch::Contains("this session is not recorded"));
}

TEST_CASE("the end of a replay is announced once, and not over another message") {
  HeadlessStage desk;
  Simulation& simulation = desk.stage.simulation();
  RecordingControl recording(desk.stage, desk.sides, false);
  simulation.play({simulation.scene, std::nullopt, {}, 2});
  recording.session_began();
  desk.sides.step();
  recording.follow_replay();
  CHECK_FALSE(desk.stage.messages.any());
  const bool over = GENERATE(true, false);
  if (over) desk.sides.step();
  if (!over) desk.stage.messages.say("Saved");
  if (over) recording.follow_replay();
  if (!over) recording.take_over_replay();
  CHECK(desk.stage.messages.text() == (over ? "The replay is over: the tissue can be grabbed" : "Saved"));
  CHECK_FALSE(simulation.replaying());
  desk.stage.messages.clear();
  recording.follow_replay();
  CHECK_FALSE(desk.stage.messages.any());
}
