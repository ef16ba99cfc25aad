// The kernels that a scene needs, run once by a body that moves and is held as the scene will be. Drivers keep what they compiled on disk:
// what was rehearsed anywhere, in any context, is there in milliseconds where it is needed. They keep it by the text of the program, and
// llvmpipe also by the sizes of the buffers that it reads (their bits 8 to 15, and whether they are powers of two). So the body is the
// scene's own, with other values.
#pragma once
#include <cstddef>
#include <functional>

#include "render/gl/program.h"
#include "sim/gpu/features.h"
#include "sim/model.h"

namespace fascia {

/// All that decides about the programs of a solver and about its buffers.
struct KernelUse {
  SolverSettings solver;  // what does not decide has one value for all
  Features features;
  std::size_t vertices = 0, tets = 0, materials = 0, fixed = 0, moved = 0, drawn = 0;  // how many there are
  bool operator==(const KernelUse&) const = default;
};
KernelUse kernel_use(const SolverSettings& settings, const Model& model);

/// The model at rest and so soft that what happens at one place is not felt far away for some steps: most regions rest.
Model rehearsal_body(const Model& model);

enum class Rehearsed { nothing, steps, hands, all };  // all: with regions at rest

/// Makes a solver of a rehearsal_body() in the current context and, step by step, all programs of the use run once. `go_on` hears what is
/// done, and says whether to go on. Throws Error.
void rehearse(gl::ProgramCache& programs, const KernelUse& use, const Model& body, const std::function<bool(Rehearsed)>& go_on);

}  // namespace fascia
