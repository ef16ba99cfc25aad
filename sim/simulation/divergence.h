// A state that came apart: found again from the last sound one, step by step, to say where it began and to keep what
// repeats it.
#pragma once
#include <string>

#include "sim/simulation/simulation.h"

namespace fascia {

struct Divergence {
  Replay replay;          // from the last sound state to the lost one
  bool found = false;     // whether repeating it led to a lost state again
  double time = 0;        // at the end of the step that was lost [s]
  std::uint32_t tet = 0;  // of Model::tets: the most strained one around the lost vertices, before that step
  double strain = 0;      // of it: Frobenius norm of the Green strain
  double det_f = 1;       // of it: J

  /// "tet 12 (vertices 3 4 7 9, strain 3.1, J -0.4) came apart at 1.25 s".
  std::string text(const Model& model) const;
};

/// `lost`: what check_now() or diverged() found. The simulation goes back to its last sound state, at rest.
Divergence find_divergence(Simulation& simulation, std::uint32_t lost);

/// For commands without a window: nothing if the state is sound; else writes a replay into the working folder, or the
/// folder for temporary files where that cannot be written, and throws an Error that says what came apart and names the
/// replay. Throws gl::ContextLost when there is no state any more. Waits for the GPU.
void require_valid(Simulation& simulation);

/// The replay, under a dated name. Returns where.
std::filesystem::path keep_replay(const Replay& replay);

}  // namespace fascia
