#include "sim/gpu/passes/timed_passes.h"

namespace fascia {

void TimedPasses::ran(const gl::ComputePass& pass) {
  stopwatch_.mark(pass.program().label());
  bytes_[pass.program().label()] += static_cast<double>(pass.bytes());
}

std::map<std::string, KernelTime> TimedPasses::kernels() const {
  std::map<std::string, KernelTime> kernels;
  for (const auto& [kernel, ms] : stopwatch_.laps()) {
    kernels[kernel].ms += ms;
    ++kernels[kernel].runs;
  }
  for (auto& [kernel, time] : kernels) time.bytes = bytes_.at(kernel);
  return kernels;
}

}  // namespace fascia
