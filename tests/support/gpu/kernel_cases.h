// Small bodies that together run every kernel of the solver: all methods with their accelerations, laws, elements,
// integrators, energy terms, heat maps and readbacks. For tests of what kernels have in common.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "sim/gpu/solver.h"

namespace fascia::test {

struct KernelCase {
  std::string name;  // "jacobi + chebyshev", "damped squared"
  Model model;
  SolverSettings settings;
  bool grabbed = false, compensated = false, every_heat_map = false;
};

std::vector<KernelCase> kernel_cases();

/// Two steps, and everything that is computed from a state: heat maps, embedded points, diagnostics, checks, the lowest
/// point, steps of a part of the body. `after_step` may draw.
void run_all(const KernelCase& example, gl::ProgramCache& programs,
             const std::function<void(GpuSolver&)>& after_step = {});

}  // namespace fascia::test
