#include "render/gl/timer.h"

#include <thread>

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

}  // namespace fascia::gl
