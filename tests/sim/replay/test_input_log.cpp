// Inputs of a user since the last valid state: kept in order, joined within a step, and merged into the initial values
// when dropped.
#include "sim/replay/input_log.h"

#include <catch2/catch.hpp>

using namespace fascia;

namespace {

SolverSettings iterations(int count) {
  SolverSettings settings;
  settings.iterations = count;
  return settings;
}

Material stiffness(double young_modulus) {
  Material material;
  material.young_modulus = young_modulus;
  return material;
}

Tuning start() { return {iterations(10), {stiffness(1), stiffness(2)}, {0, -9.81, 0}, {}}; }

}  // namespace

TEST_CASE("of several changes of a kind before a step the last one counts, of materials each") {
  InputLog log;
  log.restart(5, start());
  log.add({5, iterations(11)});
  log.add({5, iterations(12)});
  log.add({6, iterations(13)});
  log.add({6, MaterialInput{0, stiffness(3)}});
  log.add({6, MaterialInput{1, stiffness(4)}});
  log.add({6, MaterialInput{1, stiffness(5)}});
  log.add({6, iterations(14)});  // no longer the last of its kind at that step
  const std::vector<Input> expected{{5, iterations(12)},
                                    {6, iterations(13)},
                                    {6, MaterialInput{0, stiffness(3)}},
                                    {6, MaterialInput{1, stiffness(4)}},
                                    {6, MaterialInput{1, stiffness(5)}},
                                    {6, iterations(14)}};
  CHECK(log.begin() == 5);
  CHECK(log.inputs() == expected);
  CHECK(log.tuning().solver.iterations == 10);
}

TEST_CASE("instruments led in the same step all count, and stay where they were led when inputs are dropped") {
  const InstrumentInput probe{"probe", {{0, 1, 0}, {0, 0, 0}, 0}}, later{"probe", {{0, 2, 0}, {0, 0, 0}, 0}},
      jaws{"jaws", {{3, 0, 0}, {0, 0, 0}, 0.5}};
  InputLog log;
  log.restart(0, start());
  log.add({1, probe});
  log.add({1, jaws});
  log.add({2, later});
  CHECK(log.inputs() == std::vector<Input>{{1, probe}, {1, jaws}, {2, later}});
  log.forget_before(2);
  CHECK(log.tuning().led == std::vector<LedTool>{probe, jaws});
  log.forget_before(3);
  CHECK(log.tuning().led == std::vector<LedTool>{later, jaws});
}

TEST_CASE("dropped inputs are in the initial values of the log") {
  InputLog log;
  log.restart(0, start());
  log.add({0, iterations(20)});
  log.add({1, MaterialInput{1, stiffness(7)}});
  log.add({2, GravityInput{{1, 2, 3}}});
  log.add({3, GrabInput{{4, {0, 0, 1}, 5}}});
  log.add({3, ResetInput{}});
  log.add({4, GrabInput{}});
  log.add({9, iterations(30)});
  log.forget_before(4);
  CHECK(log.begin() == 4);
  CHECK(log.inputs() == std::vector<Input>{{4, GrabInput{}}, {9, iterations(30)}});
  CHECK(log.tuning().solver.iterations == 20);
  CHECK(log.tuning().materials == std::vector<Material>{stiffness(1), stiffness(7)});
  CHECK(log.tuning().gravity == Eigen::Vector3d(1, 2, 3));
  CHECK(log.tuning().springs == GrabInput{{4, {0, 0, 1}, 5}});
  log.forget_before(100);
  CHECK(log.inputs().empty());
  CHECK(log.tuning().springs.empty());
  CHECK(log.tuning().solver.iterations == 30);

  log.restart(7, start());
  CHECK(log.begin() == 7);
  CHECK(log.inputs().empty());
  CHECK(log.tuning().solver.iterations == 10);
}
