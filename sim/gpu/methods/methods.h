// The kernels of each solver method: how they are made, one row a method. What users read about methods is in
// sim/scene/settings/solver_choice.h.
#pragma once
#include <memory>

#include "gl/program.h"
#include "sim/gpu/methods/method.h"
#include "sim/scene/settings/solver_settings.h"

namespace fascia {

/// What a method is made from. All of it outlives the method.
struct MethodInputs {
  gl::ProgramCache& programs;
  const Model& model;  // in the order of the buffers
  SimBuffers& buffers;
  const SolverSettings& settings;
};

struct MethodKernels {
  Method method;
  std::unique_ptr<StepMethod> (*make)(const MethodInputs& inputs);
  bool orders_tets = false;  // the method puts the tets of the buffers into an order of its own
};

const MethodKernels& kernels_of(Method method);

}  // namespace fascia
