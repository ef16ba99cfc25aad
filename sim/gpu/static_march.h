// Static equilibrium on the GPU: implicit Euler steps without velocity, which only descend the energy of elasticity and
// weight, with time steps that grow until inertia vanishes (the proximal point method; as pseudo-transient
// continuation, Kelley and Keyes 1998). Prescribed motions are applied in increments first.
#pragma once
#include <functional>
#include <optional>
#include <stop_token>

#include "sim/gpu/solver.h"
#include "sim/reference/newton.h"

namespace fascia {

struct MarchGoal {
  double tolerance;                  // relative residual (reference/static_residual.h)
  std::optional<double> until = {};  // [s] when the motions stand still; none: at their end
};

/// Brings `solver` and its state to the end of all motions and to equilibrium with the solver's own method, to the
/// tolerance or to the limit of float32: when a dozen steps neither gain nor move anything. Restores the solver's
/// settings and materials. `equilibrium`: the result, with more digits than the solver's float32 holds. `iterations` of
/// the report are the method's. Ends unconverged soon after `stop` is requested. Throws Error if gravity acts on an
/// unconstrained component. `news` is called after every step, unconverged.
reference::NewtonReport march_to_equilibrium(GpuSolver& solver, const Model& model, const MarchGoal& goal,
                                             State& equilibrium, const std::stop_token& stop = {},
                                             const std::function<void(const reference::NewtonReport&)>& news = {});

}  // namespace fascia
