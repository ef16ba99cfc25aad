// A cube of 10 cm and 1 kg on the ground that two boxes squeeze, lift, hold, and slowly release.
#pragma once
#include "tests/support/models.h"

namespace fascia::test {

inline Eigen::Vector3d mean(const std::vector<Eigen::Vector3d>& values) {
  Eigen::Vector3d sum(0, 0, 0);
  for (const Eigen::Vector3d& v : values) sum += v;
  return sum / static_cast<double>(values.size());
}

struct Grasp {
  static constexpr double kFriction = 0.5, kWeight = 9.81;                          // [-], [N]
  static constexpr double kLift = 0.05;                                             // [m]
  static constexpr double kHeld = 2, kOpening = kHeld + 3, kOpened = kOpening + 4;  // [s] lifted; opening begins, ends
  Model model;

  Grasp() {
    Material material;
    material.young_modulus = 2e4;
    model = make_model(make_box(4, 4, 4, {0.1, 0.1, 0.1}), material, [](const Eigen::Vector3d&) { return false; });
    model.gravity = {0, -9.81, 0};
    Tool ground;
    ground.name = "ground";
    ground.shape = PlaneShape{{0, 0, 0}, {0, 1, 0}};
    ground.friction = kFriction;
    ground.path.emplace_back();
    model.tools.push_back(ground);
    for (const double side : {-1.0, 1.0}) {
      Tool jaw;
      jaw.name = side < 0 ? "left" : "right";
      jaw.shape = BoxShape{{0, 0, 0}, {0.1, 0.07, 0.07}};
      jaw.friction = kFriction;
      const auto at = [&](double time, double squeeze, double height) {
        return Instrument::Key{time, {0.05 + side * (0.15 - squeeze), 0.06 + height, 0.05}, {0, 0, 0}};
      };
      jaw.path = {at(0, -0.002, 0), at(0.5, 0.01, 0), at(1.5, 0.01, kLift), at(kOpening, 0.01, kLift),
                  at(kOpened, 0, kLift)};
      model.tools.push_back(jaw);
    }
  }
  static SolverSettings settings() {
    SolverSettings settings;
    settings.time_step = 1.0 / 60;
    settings.iterations = 10;
    return settings;
  }
};

}  // namespace fascia::test
