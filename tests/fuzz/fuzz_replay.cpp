// Replays. A replay is read, written and read again, and must be the same.
#include "sim/replay/replay.h"
#include "tests/fuzz/fuzz.h"

using namespace fascia;

FUZZ_TARGET(replay) {
  const Replay replay = read_replay_content("fuzz.fascia", data);
  fuzz::require(!replay.scene.bodies.empty(), "a replay has a scene with bodies");
  const std::string text = replay_to_json(replay, "");
  fuzz::require(replay_to_json(read_replay_content("fuzz.fascia", text), "") == text,
                "a written replay reads back as it was");
}
