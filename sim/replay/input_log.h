// What a user did since the last state that is known to be sound: enough to do it again.
#pragma once
#include <vector>

#include "sim/replay/replay.h"

namespace fascia {

/// Everything that inputs change.
struct Tuning {
  SolverSettings solver;
  std::vector<Material> materials;  // Model::materials
  Eigen::Vector3d gravity{0, 0, 0};
  GrabInput springs;

  void apply(const Input& input);  // of those that InputLog has
};

class InputLog {
 public:
  /// Begins anew: before step `step`, with these values.
  void restart(long step, Tuning tuning);
  /// In the order of the steps. Springs as a GrabInput, granted iterations as SolverSettings.
  void add(Input input);
  /// What happened before `step` needs no repetition.
  void forget_before(long step);

  long begin() const { return begin_; }
  const Tuning& tuning() const { return tuning_; }              // when the log begins
  const std::vector<Input>& inputs() const { return inputs_; }  // since then

 private:
  long begin_ = 0;
  Tuning tuning_;
  std::vector<Input> inputs_;
};

}  // namespace fascia
