// The user's inputs since the last known valid state: enough to repeat them.
#pragma once
#include <vector>

#include "sim/replay/replay.h"

namespace fascia {

/// All values that inputs change.
struct Tuning {
  SolverSettings solver;
  std::vector<Material> materials;  // Model::materials
  Eigen::Vector3d gravity{0, 0, 0};
  GrabInput springs;
  std::vector<LedTool> led = {};  // tools that left their paths

  void apply(const Input& input);  // only inputs that InputLog records
};

class InputLog {
 public:
  /// Clears the log: it then begins before step `step`, with these values.
  void restart(long step, Tuning tuning);
  /// Adds inputs in the order of the steps: springs as a GrabInput, granted iterations as SolverSettings.
  void add(Input input);
  /// Drops inputs before `step`, which need no repetition.
  void forget_before(long step);

  long begin() const { return begin_; }
  const Tuning& tuning() const { return tuning_; }              // at the beginning of the log
  const std::vector<Input>& inputs() const { return inputs_; }  // since the beginning

 private:
  long begin_ = 0;
  Tuning tuning_;
  std::vector<Input> inputs_;
};

}  // namespace fascia
