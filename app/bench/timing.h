// Wall-clock times of GPU work, with their spread, since other work disturbs every machine.
#pragma once
#include <functional>
#include <memory>
#include <vector>

#include "sim/gpu/solver.h"

namespace fascia {

/// Repeats `work` until a GPU has raised the clocks that it lowers at rest: an H100 takes three times as long before.
/// Does nothing on software renderers.
void warm_up(const std::function<void()>& work);

/// Time of `work` and of its GPU work, with waits before and after [ms].
double milliseconds_of(const std::function<void()>& work);

struct Spread {
  double median = 0, low = 0, high = 0;  // low and high: the 10th and 90th percentiles
};
Spread spread_of(std::vector<double> values);

/// Milliseconds per iteration, prediction and velocity update included, of one step of each solver from `start`. The
/// solvers take turns, so that a disturbance affects all of them alike; a first turn, in which kernels are compiled, is
/// not counted, and GPUs are warmed up.
std::vector<Spread> time_iterations(const std::vector<GpuSolver*>& solvers, const State& start, int repetitions);

}  // namespace fascia
