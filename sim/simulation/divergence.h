// Locates a divergence: repeats the steps from the last valid state one by one, to report where it began and to keep a
// replay that reproduces it.
#pragma once
#include <string>

#include "sim/simulation/simulation.h"

namespace fascia {

struct Divergence {
  Replay replay;          // from the last valid state to the diverged one
  bool found = false;     // whether the repetition diverged again
  double time = 0;        // at the end of the step that diverged [s]
  std::uint32_t tet = 0;  // in Model::tets: the most strained one around the diverged vertices, before that step
  double strain = 0;      // of it: Frobenius norm of the Green strain
  double det_f = 1;       // of it: J
  std::string tool;       // that it touches, or is in; empty without one

  /// "tet 12 (vertices 3 4 7 9, strain 3.1, J -0.4) diverged at 1.25 s in contact with probe".
  std::string text(const Model& model) const;
};

/// `lost`: the result of check_now() or diverged(). The simulation returns to its last valid state, at rest.
Divergence find_divergence(Simulation& simulation, std::uint32_t lost);

/// For commands without a window: does nothing if the state is valid; otherwise writes a replay to the working folder,
/// or to the folder for temporary files if that is not writable, and throws an Error that states what diverged and
/// names the replay. Throws gl::ContextLost if the state no longer exists. Waits for the GPU.
void require_valid(Simulation& simulation);

/// Writes the replay under a dated name. Returns its path.
std::filesystem::path keep_replay(const Replay& replay);

}  // namespace fascia
