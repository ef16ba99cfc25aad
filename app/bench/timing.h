// Wall-clock times of GPU work, with their spread: a machine that does other things too is never quiet.
#pragma once
#include <functional>
#include <memory>
#include <vector>

#include "sim/gpu/solver.h"

namespace fascia {

/// Of one piece of work and of the GPU work it started, waited for before and after [ms].
double milliseconds_of(const std::function<void()>& work);

struct Spread {
  double median = 0, low = 0, high = 0;  // low and high: a tenth of the values is below, above
};
Spread spread_of(std::vector<double> values);

/// Milliseconds per iteration, prediction and velocity update included, of one step of each solver from `start`. The
/// solvers take turns, so that a disturbance hits all of them alike; a first turn, in which kernels are compiled, does
/// not count.
std::vector<Spread> time_iterations(const std::vector<GpuSolver*>& solvers, const State& start, int repetitions);

}  // namespace fascia
