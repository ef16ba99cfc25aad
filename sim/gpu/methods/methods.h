// The kernels of each solver method: one row per method states how it is constructed. The descriptions for users are in
// sim/scene/settings/solver_choice.h.
#pragma once
#include <memory>

#include "gl/program.h"
#include "sim/gpu/methods/method.h"
#include "sim/scene/settings/solver_settings.h"

namespace fascia {

/// The inputs of a method. All of them outlive the method.
struct MethodInputs {
  gl::ProgramCache& programs;
  const Model& model;  // in the order of the buffers
  SimBuffers& buffers;
  const SolverSettings& settings;
};

struct MethodKernels {
  Method method;
  std::unique_ptr<StepMethod> (*make)(const MethodInputs& inputs);
  bool orders_tets = false;  // the method reorders the tets of the buffers
};

const MethodKernels& kernels_of(Method method);

}  // namespace fascia
