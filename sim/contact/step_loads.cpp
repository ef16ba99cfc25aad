#include "sim/contact/step_loads.h"

#include <algorithm>

namespace fascia {
namespace {

void add_forces(std::vector<ToolLoad>& sum, double share, const std::vector<ToolLoad>& loads) {
  sum.resize(loads.size());
  for (std::size_t tool = 0; tool < loads.size(); ++tool) {
    sum[tool].force += share * loads[tool].force;
    sum[tool].torque += share * loads[tool].torque;
    sum[tool].normal += share * loads[tool].normal;
  }
}

void add_forces(std::vector<PairLoad>& sum, double share, const std::vector<PairLoad>& loads) {
  for (const PairLoad& load : loads) {
    PairLoad& of_bodies = load_of(sum, load.bodies);
    of_bodies.force += share * load.force;
    of_bodies.normal += share * load.normal;
  }
}

}  // namespace

void StepLoads::add(double share, const ContactLoads& loads) {
  add_forces(earlier_.tools, share, loads.tools);
  add_forces(earlier_.pairs, share, loads.pairs);
  shares_ += share;
}

ContactLoads StepLoads::mean(ContactLoads last) const {
  if (shares_ == 0) return last;
  ContactLoads mean = earlier_;
  mean.on_held = last.on_held;
  add_forces(mean.tools, 1 - shares_, last.tools);
  add_forces(mean.pairs, 1 - shares_, last.pairs);
  for (std::size_t tool = 0; tool < last.tools.size(); ++tool) {
    mean.tools[tool].points = last.tools[tool].points;
    mean.tools[tool].deepest = last.tools[tool].deepest;
  }
  for (const PairLoad& load : last.pairs) {
    PairLoad& of_bodies = load_of(mean.pairs, load.bodies);
    of_bodies.pairs = load.pairs;
    of_bodies.deepest = load.deepest;
  }
  return mean;
}

}  // namespace fascia
