// How good the estimate of the error in time is: effectivity, the estimate over the error against many short steps.
// Smooth motion, hands, impacts, friction and tissue on tissue, with and without damping.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "app/verify/verification.h"
#include "base/text.h"
#include "sim/accuracy/relative_distance.h"
#include "sim/grab/build_model.h"
#include "sim/mesh/mesh_generate.h"
#include "sim/simulation/errors/time_error.h"

namespace fascia {
namespace {

constexpr int kSteps = 40, kFine = 96;   // 2/3 s; substeps of the truth, by SDIRK2
constexpr double kLow = 0.5, kHigh = 2;  // the factor of two that an estimate may be off by

/// A scene whose bodies are boxes, in the order of its bodies.
struct MovedScene {
  const char* name;
  const char* scene;
  std::vector<TetMesh> meshes;
};

TetMesh bar() { return make_box(4, 1, 1, {0.2, 0.05, 0.05}); }
TetMesh block(double size) { return make_box(2, 2, 2, {size, size, size}); }

std::vector<MovedScene> motions() {
  return {{"released bar, no damping",
           R"({"fascia_scene": 1, "bodies": [{"mesh": "bar", "fixed": [{"box": [[-1, -1, -1],
      [0.001, 1, 1]]}], "materials": {"default": {"young_modulus": 4e5, "poisson_ratio": 0.3, "density": 1000}}}]})",
           {bar()}},
          {"bar under a hand, no damping, nu = 0.3",
           R"({"fascia_scene": 1, "gravity": [0, 0, 0], "bodies": [{"mesh":
      "bar", "fixed": [{"box": [[-1, -1, -1], [0.001, 1, 1]]}], "materials": {"default": {"young_modulus": 1e5,
      "poisson_ratio": 0.3, "density": 1000}}}], "grabs": [{"select": {"box": [[0.199, -1, -1], [1, 1, 1]]},
      "translate": [0.03, 0.06, 0], "stiffness": 2000, "duration": 0.2}]})",
           {bar()}},
          {"quadratic bar under a hand, no damping, nu = 0.45",
           R"({"fascia_scene": 1, "gravity": [0, 0, 0], "bodies":
      [{"mesh": "bar", "elements": "quadratic", "fixed": [{"box": [[-1, -1, -1], [0.001, 1, 1]]}], "materials":
      {"default": {"young_modulus": 1e5, "poisson_ratio": 0.45, "density": 1000}}}], "grabs": [{"select": {"box":
      [[0.199, -1, -1], [1, 1, 1]]}, "translate": [0.03, 0.06, 0], "stiffness": 2000, "duration": 0.2}]})",
           {bar()}},
          {"damped bar that a hand lets go",
           R"({"fascia_scene": 1, "gravity": [0, 0, 0], "bodies": [{"mesh": "bar",
      "fixed": [{"box": [[-1, -1, -1], [0.001, 1, 1]]}], "materials": {"default": {"young_modulus": 1e5,
      "poisson_ratio": 0.4, "density": 1000, "damping": 0.02}}}], "grabs": [{"select": {"box": [[0.199, -1, -1],
      [1, 1, 1]]}, "translate": [0.03, 0.06, 0], "stiffness": 2000, "duration": 0.2, "release": 0.3}]})",
           {bar()}},
          {"block that falls on the ground",
           R"({"fascia_scene": 1, "bodies": [{"mesh": "block", "transform":
      {"rotate_deg": [10, 20, 30], "translate": [0, 0.06, 0]}, "materials": {"default": {"young_modulus": 2e4,
      "poisson_ratio": 0.4, "density": 1000, "damping": 0.01}}}], "ground": {"friction": 0.4}})",
           {block(0.1)}},
          {"block that slides",
           R"({"fascia_scene": 1, "bodies": [{"mesh": "block", "initial_velocity": [0.8, 0, 0],
      "transform": {"translate": [0, 0.002, 0]}, "materials": {"default": {"young_modulus": 5e4, "poisson_ratio": 0.4,
      "density": 1000, "damping": 0.01}}}], "ground": {"friction": 0.3}})",
           {block(0.1)}},
          {"ball that presses and drags a block",
           R"({"fascia_scene": 1, "bodies": [{"mesh": "block", "fixed":
      [{"lowest": 0.05}], "materials": {"default": {"young_modulus": 2e4, "poisson_ratio": 0.45, "density": 1000,
      "damping": 0.01}}}], "instruments": [{"name": "ball", "friction": 0.3, "shape": {"sphere": {"center": [0, 0, 0],
      "radius": 0.02}}, "path": [{"time": 0, "position": [0.03, 0.13, 0.05]}, {"time": 0.3, "position": [0.03, 0.105,
      0.05]}, {"time": 0.7, "position": [0.07, 0.105, 0.05]}]}]})",
           {block(0.1)}},
          {"block that falls on another",
           R"({"fascia_scene": 1, "contact": {"friction": 0.4}, "bodies": [{"name":
      "below", "mesh": "block", "fixed": [{"lowest": 0.05}], "materials": {"default": {"young_modulus": 2e4,
      "poisson_ratio": 0.4, "density": 1000, "damping": 0.02}}}, {"name": "above", "mesh": "small", "transform":
      {"rotate_deg": [0, 25, 0], "translate": [0.02, 0.125, 0.03]}, "materials": {"default": {"young_modulus": 4e4,
      "poisson_ratio": 0.4, "density": 1000, "damping": 0.02}}}]})",
           {block(0.1), block(0.06)}}};
}

std::unique_ptr<Simulation> after(const MovedScene& motion, Integrator integrator, int substeps) {
  Scene scene = read_scene_content(motion.name, motion.scene);
  scene.solver.integrator = integrator;
  scene.solver.substeps = substeps;
  scene.solver.rest_speed = 0;
  auto simulation = std::make_unique<Simulation>(scene, build_model(scene, motion.meshes), nullptr, true);
  for (int step = 0; step < kSteps; ++step) simulation->step();
  return simulation;
}

}  // namespace

void verify_estimates_in_time(Verification& verification) {
  const char* const kTest = "Estimated error in time";
  for (const MovedScene& motion : motions()) {
    const std::vector<Eigen::Vector3d> exact = after(motion, Integrator::sdirk2, kFine)->state().displacement;
    for (const IntegratorInfo& info : integrators()) {
      const auto run = after(motion, info.integrator, 1);
      const double error = relative_distance(run->state().displacement, exact);
      const TimeError estimate = estimate_time_error(*run, nullptr);
      verification.add({kTest,
                        std::string(motion.name) + ", " + info.label + ": estimate over error" +
                            (estimate.resolved ? "" : ", a bound"),
                        "", estimate.relative / error, kLow,
                        estimate.resolved ? kHigh : std::numeric_limits<double>::infinity(),
                        "error " + number(100 * error) + " % after " + std::to_string(kSteps) +
                            " steps, against SDIRK2 with " + std::to_string(kFine) + " times as many"});
    }
  }
}

}  // namespace fascia
