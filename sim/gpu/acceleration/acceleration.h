// What accelerates a method from outside: passes before and after its iterations. Accelerations that are part of a
// method's own iterations (subspace and nonlinear_cg of two_level) are not among these. What users read about
// accelerations is in sim/scene/settings/solver_choice.h.
#pragma once
#include <memory>
#include <vector>

#include "sim/gpu/acceleration/anderson.h"
#include "sim/scene/settings/solver_settings.h"

namespace fascia {

class StepAcceleration {
 public:
  StepAcceleration() = default;
  virtual ~StepAcceleration() = default;
  StepAcceleration(const StepAcceleration&) = delete;
  StepAcceleration& operator=(const StepAcceleration&) = delete;

  virtual Passes begin(const Recording&) const { return {}; }  // once a substep, before the first iteration
  virtual Passes after_iteration(const Recording& recording, bool first) const = 0;
  virtual void values_changed() {}  // materials, masses or h
};

struct AccelerationInputs {
  const gl::ProgramCache& programs;
  const SimBuffers& buffers;
  const SolverSettings& settings;
  std::vector<AndersonPart> state;  // all that the method iterates on; empty: the method accelerates itself
};

/// The acceleration of the settings, or null where there is none from outside. The buffers must outlive it.
std::unique_ptr<StepAcceleration> make_acceleration(const AccelerationInputs& inputs);

}  // namespace fascia
