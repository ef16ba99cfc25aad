// Simulates a scene as it was measured: in motion, or as static equilibria at the times of the measurement.
#pragma once
#include <optional>
#include <set>
#include <vector>

#include "sim/contact/tool_load.h"
#include "sim/integrators/stage.h"
#include "sim/model/model.h"
#include "sim/model/state.h"
#include "sim/scene/scene.h"

namespace fascia {

/// What is observed at one time.
struct Moment {
  double time = 0;    // [s]
  bool last = false;  // equilibrium after all motions
  State state;
  std::vector<GrabSpring> springs = {};
  std::vector<ToolLoad> loads = {};
  std::vector<Eigen::Vector3d> contact = {};  // [vertex] its forces on the tissue [N]
  std::size_t stages = 0;                     // of a motion, that lead to it
};

/// A stage of a time integrator as it was simulated.
struct SimulatedStage {
  IntegratorStage stage;
  double step_end;  // [s] of the step that it is a part of
  State before;
};

struct Course {
  std::vector<Moment> moments;         // in ascending order of time
  std::vector<SimulatedStage> stages;  // of a motion, if it is differentiable
  bool differentiable = false;         // whether sim/fit/simulated/moved_moments.h knows its rates
};

/// When a scene is observed.
struct Schedule {
  bool is_static = false;
  std::vector<double> times = {};  // [s] ascending
  bool has_end = false;            // also at `end`, or at the equilibrium after all motions
  double end = 0;                  // [s]
};

class Simulator {
 public:
  virtual ~Simulator() = default;
  /// None where the simulation does not converge or is stopped.
  virtual std::optional<Course> run(const Scene& scene, const Model& model, const Schedule& schedule) const = 0;
  virtual std::size_t most_threads() const = 0;  // that may call run() at once
  /// Of a free value's inner coordinate, for differences of two runs: larger than what their tolerances leave.
  virtual double difference_step() const = 0;
};

/// The steps of a motion that is observed: at those before and behind every time, values being interpolated.
struct ObservedSteps {
  ObservedSteps(const Schedule& schedule, double time_step);
  long count = 1;
  std::set<long> numbers;  // 0: the start
};

/// The springs of the scene's grabs at a moment.
std::vector<GrabSpring> springs_at(const Model& model, const Moment& moment);

/// The moments of a static schedule, without states.
std::vector<Moment> static_moments(const Model& model, const Schedule& schedule);

}  // namespace fascia
