#include "render/gl/timer.h"

#include <thread>

#include "render/gl/stopwatch.h"
#include "tests/render/gl/gl_support.h"

namespace fascia::gl {

TEST_CASE("a timer sees the time that passes") {
  const auto context = test::each_context();
  Timer timer;
  CHECK(timer.milliseconds() == 0);
  for (int i = 0; i < 6; ++i) {  // more often than measurements fit in the ring
    timer.begin();
    if (device().software) std::this_thread::sleep_for(std::chrono::milliseconds(2));
    timer.end();
    Finish();
  }
  CHECK(timer.milliseconds() >= (device().software ? 2.0 : 0.0));
  CHECK(GetError() == GL_NO_ERROR);
}

TEST_CASE("a stopwatch tells pieces by their names, in their order") {
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

TEST_CASE("a stopwatch by timestamps asks the device for as many as there are pieces") {
  const auto context = test::each_context();
  {
    Stopwatch stopwatch(true);  // whose values say nothing on software renderers
    stopwatch.mark("one");
    stopwatch.mark("two");
    CHECK(stopwatch.laps().size() == 2);
  }
  CHECK(GetError() == GL_NO_ERROR);
}

}  // namespace fascia::gl
