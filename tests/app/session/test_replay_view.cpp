#include "app/session/replay_view.h"

#include <catch2/catch.hpp>
#include <cmath>

using namespace fascia;

TEST_CASE("a recorded camera moves smoothly, passes the recorded keys, and rests where it rested", "[session]") {
  Replay replay;
  const auto turned = [](double angle) {
    return CameraSettings{{2 * std::sin(angle), 0.5, 2 * std::cos(angle)}, {0, 0, 0}, {0, 1, 0}, 40};
  };
  replay.inputs.push_back({0, turned(0)});
  for (long step = 100; step <= 140; ++step)
    replay.inputs.push_back({step, turned(0.01 * static_cast<double>(step - 99))});
  DisplaySettings shown;
  shown.color = ColorBy::strain;
  replay.inputs.push_back({200, shown});
  const ReplayView view(replay);
  CHECK(view.camera(50)->eye == turned(0).eye);
  CHECK(view.camera(97)->eye == turned(0).eye);
  for (long step = 100; step <= 140; ++step)
    CHECK((view.camera(static_cast<double>(step))->eye - turned(0.01 * static_cast<double>(step - 99)).eye).norm() <
          1e-12);
  CHECK(view.camera(1000)->eye == turned(0.01 * static_cast<double>(140 - 99)).eye);
  // In the middle of the rotation the path is the circle itself, up to the error of a cubic over one interval, which is
  // far below its length.
  for (double step = 105; step < 135; step += 0.25)
    CHECK((view.camera(step)->eye - turned(0.01 * (step - 99)).eye).norm() < 1e-6);
  CHECK_FALSE(view.display(199.5));
  CHECK(view.display(200)->color == ColorBy::strain);
  CHECK_FALSE(ReplayView(Replay{}).camera(3));
}
