// Counts the work of the solver's steps: iterations, dispatches, bytes.
#include <algorithm>
#include <set>

#include "sim/gpu/solver.h"

namespace fascia {

int GpuSolver::last_iterations() const {
  if (!stop_ || stages_solved_ == 0) return settings_.iterations;
  return static_cast<int>(
      std::min(stop_->state().read<std::uint32_t>().front(), static_cast<std::uint32_t>(settings_.iterations)));
}

double GpuSolver::mean_iterations() const {
  if (!stop_ || stages_solved_ == 0) return settings_.iterations;
  return static_cast<double>(stop_->state().read<std::uint32_t>().back()) / static_cast<double>(stages_solved_);
}

double GpuSolver::share_solved() const {
  const double all = static_cast<double>(steps_solved_) * buffers_.work();
  return all > 0 ? static_cast<double>(work_done_) / all : 1;
}

double GpuSolver::bytes_per_iteration() const {
  const auto bytes_of = [&](const Passes& passes) {
    double bytes = 0;
    std::set<const gl::Program*> counted;  // the colors of a sweep share their data
    for (const gl::ComputePass& pass : passes)
      if (!(deferred_ && pass.arguments() == &deferred_->lists) && counted.insert(&pass.program()).second)
        bytes += static_cast<double>(pass.bytes());
    return bytes;
  };
  const StepPasses& passes = whole_kind().passes;
  return bytes_of(passes.iteration) + bytes_of(passes.before) / before_every_ +
         bytes_of(passes.refresh) * refreshes() / settings_.iterations;
}

int GpuSolver::refreshes() const {
  int count = 0;
  for (int i = 0; i < settings_.iterations; ++i) count += StepMethod::refreshes_before(i, settings_.iterations);
  return count;
}

std::uint64_t GpuSolver::dispatches_per_step() const {
  if (whole_kind().fused) {
    const FusedStep& fused = *whole_kind().fused;
    std::uint64_t count = fused.begin.dispatches(1) + fused.first.dispatches(1) + fused.end.dispatches(1);
    if (!whole_kind().passes.check.empty()) count += fused.check.dispatches(1);
    count += refreshes() * fused.refresh.dispatches(1);
    for (int i = 1; i < settings_.iterations; i = alike_from(i))
      count += renews(i) ? fused.renew.dispatches(1)
                         : fused.iteration.dispatches(static_cast<std::uint32_t>(alike_from(i) - i));
    return settings_.stages_per_step() * count;
  }
  std::uint64_t renewed = 0;
  for (int i = 0; i < settings_.iterations; ++i) renewed += renews(i);
  const std::uint64_t others = (settings_.iterations - 1) / before_every_ - renewed;  // runs of before_ after the first
  const StepPasses& passes = whole_kind().passes;
  const std::uint64_t iterations = passes.before_first.size() + others * passes.before.size() +
                                   passes.first_iteration.size() +
                                   (settings_.iterations - 1 - renewed) * passes.iteration.size() +
                                   renewed * passes.renew.size() + refreshes() * passes.refresh.size();
  return settings_.stages_per_step() * (passes.begin.size() + iterations + passes.check.size() + passes.end.size());
}

}  // namespace fascia
