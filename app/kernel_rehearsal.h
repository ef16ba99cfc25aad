// The kernels that a scene needs, asked for by a small body that moves and is held as the scene will be. Drivers keep what they compiled
// on disk by the text of the program: what was rehearsed anywhere, in any context, is there in milliseconds where it is needed.
#pragma once
#include <functional>

#include "render/gl/program.h"
#include "sim/gpu/features.h"
#include "sim/model.h"

namespace fascia {

/// All that decides about the programs of a solver.
struct KernelUse {
  SolverSettings solver;  // what does not decide has one value for all
  Features features;
  bool rests = false;      // regions may, while others move (sim/gpu/regions.h)
  bool coarse = false;     // enough free vertices for a coarse level
  bool held = false, prescribed = false;
  bool embedded = false;   // a surface is drawn
  bool operator==(const KernelUse&) const = default;
};
KernelUse kernel_use(const SolverSettings& settings, const Model& model);

/// Needs the same programs as the model that the use is of: a soft bar, of which one end moves.
Model rehearsal_body(const KernelUse& use);

enum class Rehearsed { nothing, steps, hands, all };  // all: with regions at rest

/// Makes a solver in the current context and, step by step, all programs of the use run once. `go_on` hears what is done, and says whether
/// to go on. Throws Error.
void rehearse(gl::ProgramCache& programs, const KernelUse& use, const std::function<bool(Rehearsed)>& go_on);

}  // namespace fascia
