// Grabs that follow a path: their position over time, and the time in which they hold.
#include "sim/model/resolved_grab.h"

#include <catch2/catch.hpp>

using namespace fascia;
using Eigen::Vector3d;

namespace {

ResolvedGrab grab_of(std::vector<ScriptedGrab::Key> path) {
  ResolvedGrab grab;
  grab.grip = {{3, {0, 0, 0}, 10, 1}, {5, {0, 0, 0}, 20, 1}};
  grab.path = std::move(path);
  return grab;
}

}  // namespace

TEST_CASE("a path is straight between its keys, and stands before the first and after the last") {
  const ResolvedGrab grab = grab_of({{1, {0, 0, 0}}, {2, {4, 0, 0}}, {4, {4, 2, 0}}});
  CHECK(grab.displacement(-5) == Vector3d(0, 0, 0));
  CHECK(grab.displacement(1) == Vector3d(0, 0, 0));
  CHECK((grab.displacement(1.25) - Vector3d(1, 0, 0)).norm() < 1e-15);
  CHECK(grab.displacement(2) == Vector3d(4, 0, 0));
  CHECK((grab.displacement(3.5) - Vector3d(4, 1.5, 0)).norm() < 1e-15);
  CHECK(grab.displacement(4) == Vector3d(4, 2, 0));
  CHECK(grab.displacement(1e9) == Vector3d(4, 2, 0));
}

TEST_CASE("a smooth path eases in and out of every key") {
  ResolvedGrab grab = grab_of({{0, {0, 0, 0}}, {1, {1, 0, 0}}, {3, {0, 0, 0}}});
  grab.smooth = true;
  for (const double s : {0.1, 0.25, 0.5, 0.8}) {
    CAPTURE(s);
    const double share = s * s * (3 - 2 * s);
    CHECK(grab.displacement(s).x() == Approx(share));
    CHECK(grab.displacement(1 + 2 * s).x() == Approx(1 - share));
  }
  for (const double key : {0.0, 1.0, 3.0}) {  // no speed at the keys
    CAPTURE(key);
    CHECK((grab.displacement(key + 1e-4) - grab.displacement(key - 1e-4)).norm() < 1e-7);
  }
}

TEST_CASE("two keys of one time are a jump") {
  const ResolvedGrab grab = grab_of({{0, {0, 0, 0}}, {1, {0, 0, 0}}, {1, {1, 0, 0}}, {2, {1, 0, 0}}});
  CHECK(grab.displacement(0.999) == Vector3d(0, 0, 0));
  CHECK(grab.displacement(1) == Vector3d(1, 0, 0));
}

TEST_CASE("springs hold after the start and up to the release, after the springs of other grabs") {
  ResolvedGrab grab = grab_of({{1, {0, 0, 0}}, {2, {2, 0, 0}}});
  grab.start = 1;
  grab.release = 3;
  const std::vector<ResolvedGrab> grabs{grab, grab_of({{0, {0, 0, 7}}})};
  const GrabSpring other{8, {1, 1, 1}, 5, 0};
  CHECK(with_grabs({}, {}, 1).empty());
  CHECK(with_grabs({other}, grabs, 1).size() == 3);  // the first grab does not hold yet
  const std::vector<GrabSpring> springs = with_grabs({other}, grabs, 1.5);
  REQUIRE(springs.size() == 5);
  CHECK(springs[0] == other);
  CHECK(springs[1] == GrabSpring{3, {1, 0, 0}, 10, 1});
  CHECK(springs[2] == GrabSpring{5, {1, 0, 0}, 20, 1});
  CHECK(springs[3] == GrabSpring{3, {0, 0, 7}, 10, 1});
  CHECK(with_grabs({}, grabs, 3).size() == 4);
  CHECK(with_grabs({}, grabs, 3.001).size() == 2);

  const std::vector<GrabSpring> last = with_grabs_at_last({other}, grabs);  // a grab at its release, too
  REQUIRE(last.size() == 5);
  CHECK(last[0] == other);
  CHECK(last[2].target == Vector3d(2, 0, 0));
  CHECK(last[4].target == Vector3d(0, 0, 7));
}

TEST_CASE("roundings of times that are sums of substeps do not move a grab by a step") {
  const int substeps = GENERATE(1, 2, 3, 4, 8, 16);
  CAPTURE(substeps);
  constexpr double kStep = 1.0 / 60;
  ResolvedGrab grab;
  grab.grip = {{0, {0, 0, 0}, 1}};
  grab.path = {{0.1, {0, 0, 0}}};
  grab.start = 0.1;
  grab.release = 0.6;
  const std::vector<ResolvedGrab> grabs{grab};
  double time = 0;
  int held = 0;
  for (int step = 0; step < 60; ++step) {
    held += !with_grabs({}, grabs, time + kStep).empty();
    for (int k = 0; k < substeps; ++k) time += kStep / substeps;
  }
  CHECK(held == 30);
}

TEST_CASE("a grab ends with its release, or where its path does, not before it starts") {
  ResolvedGrab grab = grab_of({{1, {0, 0, 0}}, {2, {2, 0, 0}}});
  CHECK(grab.end() == 2);
  grab.start = 5;
  CHECK(grab.end() == 5);
  grab.release = 1.5;
  CHECK(grab.end() == 1.5);
}
