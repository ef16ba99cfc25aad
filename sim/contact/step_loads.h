// Loads of contact over a step that several stages make up. Forces at the end of its last stage are not what has moved
// the tissue: SDIRK2 moves it by the first stage with 1/sqrt 2 of the step, and by the last one with the rest. The mean
// by these shares, times the length of the step, is the impulse of contact.
#pragma once
#include "sim/contact/pair_energy.h"
#include "sim/contact/tool_load.h"

namespace fascia {

struct ContactLoads {
  std::vector<ToolLoad> tools;  // [tool of the model]
  std::vector<PairLoad> pairs;
  Eigen::Vector3d on_held{0, 0, 0};  // of both on held vertices, at the end of the last stage [N]
};

class StepLoads {
 public:
  void begin() { earlier_ = {}, shares_ = 0; }
  /// Of a stage that is not the step's last one, whose `share` is IntegratorStage::share over the number of substeps.
  void add(double share, const ContactLoads& loads);
  /// Over the step whose last stage has the loads `last`; points, pairs and depths are those of that stage. Without
  /// earlier stages, `last` itself.
  ContactLoads mean(ContactLoads last) const;

 private:
  ContactLoads earlier_;  // sums of shares of the forces
  double shares_ = 0;     // of the earlier stages
};

}  // namespace fascia
