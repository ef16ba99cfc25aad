// Times of work on the device.
// Covers: gl/timing/stopwatch, gl/timing/timestamps
#include "gl/timing/timer.h"

#include <thread>

#include "gl/timing/stopwatch.h"
#include "gl/timing/timestamps.h"
#include "tests/gl/gl_support.h"

namespace fascia::gl {

TEST_CASE("a timer measures the elapsed time") {
  const auto context = test::each_context();
  Timer timer;
  CHECK_FALSE(timer.take().has_value());
  const auto measure = [&](int steps, bool compiled) {
    timer.begin();
    if (device().software) std::this_thread::sleep_for(std::chrono::milliseconds(2));
    timer.end(steps, compiled);
    Finish();
  };
  constexpr int kFit = 4;
  for (int i = 0; i < kFit + 2; ++i) measure(i, i == 1);  // the last two are not measured
  for (int i = 0; i < kFit; ++i) {
    CAPTURE(i);
    const auto taken = timer.take();
    REQUIRE(taken.has_value());
    CHECK(taken->milliseconds >= (device().software ? 2.0 : 0.0));
    CHECK(taken->steps == i);
    CHECK(taken->compiled == (i == 1));
  }
  CHECK_FALSE(timer.take().has_value());
  measure(9, false);
  const auto taken = timer.take();
  REQUIRE(taken.has_value());
  CHECK(taken->steps == 9);
  CHECK(GetError() == GL_NO_ERROR);
}

TEST_CASE("the device's counter of time may wrap around") {
  constexpr GLuint64 kLast = (GLuint64{1} << 36) - 1;
  CHECK(milliseconds_between(1'000'000, 3'500'000, 64) == 2.5);
  CHECK(milliseconds_between(1'000'000, 3'500'000, 36) == 2.5);
  CHECK(milliseconds_between(kLast - 499'999, 1'500'000, 36) == 2);
  CHECK(milliseconds_between(kLast - 499'999, 1'500'000, 64) == 0);  // it did not report its 36 bits
}

TEST_CASE("a stopwatch reports pieces by name, in order") {
  const auto context = test::each_context();
  Stopwatch stopwatch(false);
  std::this_thread::sleep_for(std::chrono::milliseconds(2));
  stopwatch.mark("long");
  stopwatch.mark("short");
  const auto laps = stopwatch.laps();
  REQUIRE(laps.size() == 2);
  CHECK(laps[0].first == "long");
  CHECK(laps[0].second >= 2);
  CHECK(laps[1].first == "short");
  CHECK(laps[1].second >= 0);
}

TEST_CASE("a stopwatch with timestamps queries one per piece") {
  const auto context = test::each_context();
  {
    Stopwatch stopwatch(true);  // its values are undefined on software renderers
    stopwatch.mark("one");
    stopwatch.mark("two");
    CHECK(stopwatch.laps().size() == 2);
  }
  CHECK(GetError() == GL_NO_ERROR);
}

}  // namespace fascia::gl
