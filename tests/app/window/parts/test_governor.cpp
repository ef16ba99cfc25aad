// When the quality of moving pictures changes, with frame times made up.
#include <catch2/catch.hpp>

#include "app/window/parts/governor.h"

using fascia::Governor;

namespace {

// `seconds` of frames; returns the highest number of changes within any second.
int run(Governor& governor, double seconds, double frame, double picture, bool moves = true, bool compiled = false) {
  int changes = 0, level = governor.level();
  for (double t = 0; t < seconds; t += frame) {
    governor.follow(frame, picture, moves, compiled);
    changes += governor.level() != level;
    level = governor.level();
  }
  return changes;
}

}  // namespace

TEST_CASE("slow pictures lower the quality level by level, at most once a second, and fast ones raise it") {
  Governor governor(true);
  run(governor, 0.45, 0.050, 0.030);
  CHECK(governor.level() == 0);
  CHECK(run(governor, 0.15, 0.050, 0.030) == 1);
  CHECK(run(governor, 0.75, 0.050, 0.030) == 0);
  CHECK(run(governor, 0.25, 0.050, 0.030) == 1);
  run(governor, 10, 0.050, 0.030);
  CHECK(governor.level() == Governor::kLevels);
  CHECK(run(governor, 1.5, 0.020, 0.012) == 0);
  CHECK(run(governor, 2, 0.020, 0.012) == 1);
  run(governor, 10, 0.020, 0.012);
  CHECK(governor.level() == 0);
}

TEST_CASE("between fast and slow nothing changes") {
  Governor governor(true);
  run(governor, 0.6, 0.050, 0.030);
  REQUIRE(governor.level() == 1);
  CHECK(run(governor, 60, 0.033, 0.020) == 0);
  for (int i = 0; i < 500; ++i) {  // a slow frame now and then
    governor.follow(0.030, 0.020, true, false);
    governor.follow(i % 20 == 0 ? 0.09 : 0.030, 0.020, true, false);
  }
  CHECK(governor.level() == 1);
}

TEST_CASE("a still picture has full quality at once, and the level returns with the motion") {
  Governor governor(true);
  run(governor, 10, 0.060, 0.030);
  REQUIRE(governor.level() == Governor::kLevels);
  governor.follow(0.06, 0.03, false, false);
  CHECK(governor.level() == 0);
  governor.follow(0.06, 0.03, true, false);
  CHECK(governor.level() == Governor::kLevels);
}

TEST_CASE("frames that say nothing about pictures change nothing") {
  Governor governor(true);
  SECTION("kernels are compiled") { run(governor, 10, 0.3, 0.03, true, true); }
  SECTION("all of the time are steps") { run(governor, 10, 0.1, 0.006); }
  SECTION("gaps") { run(governor, 10, 0.8, 0.7); }
  SECTION("still") { run(governor, 10, 0.1, 0.1, false); }
  CHECK(governor.level() == 0);
  Governor idle(false);  // on a GPU, or with --quality full
  run(idle, 10, 0.1, 0.1);
  CHECK(idle.level() == 0);
}

TEST_CASE("every level saves more than the one above it, and effects of still pictures are not touched") {
  const fascia::Quality full = fascia::kFullQuality;
  CHECK(lowered(full, 0) == full);
  for (int level = 1; level <= Governor::kLevels; ++level) {
    CAPTURE(level);
    const fascia::Quality above = lowered(full, level - 1), here = lowered(full, level);
    CHECK((here.shadow_taps < above.shadow_taps || here.shadow_every > above.shadow_every));
    CHECK(here.detail == full.detail);
    CHECK(here.edge_smoothing == full.edge_smoothing);
  }
}
