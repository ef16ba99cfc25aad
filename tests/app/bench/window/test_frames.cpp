// The figures of a window's session, from logs made by hand.
#include <catch2/catch.hpp>

#include "app/bench/window/frames.h"
#include "base/error.h"
#include "base/file.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

namespace {

// Frames of 50 ms with two steps each, from `first` on; the pointer of a frame is that of `delay` s before its end.
WindowSession session_at(double first, double delay) {
  WindowSession session;
  session.started = first - 0.4;
  session.pressed = first + 1;
  session.released = first + 6;
  for (int k = 0; k < 100; ++k) session.puts.push_back({session.pressed + 0.1 + 0.04 * k, 300.0 + 3 * k, 200});
  for (int i = 0; i < 120; ++i) {
    LoggedFrame frame;
    frame.ended = first + 0.05 * i;
    frame.elapsed_ms = 50;
    frame.steps = 2;
    frame.simulated_s = 0.04;
    frame.fused = i >= 30;
    frame.parts_ms = {{"steps_ms", 18}, {"scene_ms", 20}};
    for (const PointerPut& put : session.puts)
      if (put.at <= frame.ended - delay) frame.x = put.x, frame.y = put.y;
    session.frames.push_back(frame);
  }
  return session;
}

}  // namespace

TEST_CASE("figures of a session with even frames") {
  const WindowFigures f = figures_of(session_at(1000, 0.06));
  CHECK(f.first_picture_s == Approx(0.4));
  CHECK(f.fused_s == Approx(1.5));
  CHECK(f.share == Approx(0.8));
  CHECK(f.pictures_per_s == Approx(20));
  CHECK(f.frame_ms.median == Approx(50));
  CHECK(f.steps_per_frame == Approx(2));
  CHECK(f.step_ms == Approx(9));
  CHECK(f.parts_ms.at("scene_ms") == Approx(20));
  CHECK(f.longest_before_ms == Approx(50));
  CHECK(f.longest_grabbed_ms == Approx(50));
  // A place is drawn at the end of the first frame that begins to know it: 60 to 110 ms later.
  CHECK(f.latency_ms.low > 59.9);
  CHECK(f.latency_ms.high < 110.1);
  CHECK(f.latency_ms.median == Approx(85).margin(10));
}

TEST_CASE("a frame that takes long counts where it was, before the grab or after it") {
  WindowSession session = session_at(50, 0.06);
  const auto delay_from = [&](std::size_t i, double seconds) {
    for (; i < session.frames.size(); ++i) session.frames[i].ended += seconds;
  };
  SECTION("before") {
    delay_from(5, 0.3);
    CHECK(figures_of(session).longest_before_ms == Approx(350));
    CHECK(figures_of(session).longest_grabbed_ms == Approx(50));
  }
  SECTION("at the grab") {
    delay_from(21, 0.7);
    CHECK(figures_of(session).longest_before_ms == Approx(50));
    CHECK(figures_of(session).longest_grabbed_ms == Approx(750));
    CHECK(figures_of(session).share == Approx(0.8));  // the first second after it is not counted
  }
}

TEST_CASE("a session without frames during the drag has no figures") {
  WindowSession session = session_at(50, 0.06);
  session.frames.resize(10);
  CHECK_THROWS_WITH(figures_of(session), Catch::Contains("less than two frames"));
}

TEST_CASE("a log of frames is read by the names of its columns, and other files are refused") {
  const TemporaryFolder folder;
  write_file(folder / "frames.csv",
             "ended_s,elapsed_ms,steps_ms,steps,simulated_s,fused,pointer_x,pointer_y\n12.5,20,7.5,2,0.04,1,10,20\n");
  const std::vector<LoggedFrame> frames = read_frame_log(folder / "frames.csv");
  REQUIRE(frames.size() == 1);
  CHECK(frames[0].ended == 12.5);
  CHECK(frames[0].elapsed_ms == 20);
  CHECK(frames[0].parts_ms == std::map<std::string, double>{{"steps_ms", 7.5}});
  CHECK(frames[0].steps == 2);
  CHECK(frames[0].simulated_s == 0.04);
  CHECK(frames[0].fused);
  CHECK(frames[0].x == 10);
  CHECK(frames[0].y == 20);
  write_file(folder / "other.csv", "a,b\n1,2\n");
  CHECK_THROWS_WITH(read_frame_log(folder / "other.csv"), Catch::Contains("has no column ended_s"));
  write_file(folder / "cut.csv", "ended_s,elapsed_ms,steps,simulated_s,fused,pointer_x,pointer_y\n12.5,20\n");
  CHECK_THROWS_WITH(read_frame_log(folder / "cut.csv"), Catch::Contains("line 2"));
}
