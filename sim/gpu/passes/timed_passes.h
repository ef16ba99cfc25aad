// Times the passes of a step one by one, by the names of their kernels.
#pragma once
#include <map>
#include <string>

#include "gl/compute_pass.h"
#include "gl/timing/stopwatch.h"

namespace fascia {

struct KernelTime {
  double ms = 0;     // of all runs together
  double bytes = 0;  // the same; an estimate of the memory traffic: every buffer that a pass uses, once
  int runs = 0;
};

class TimedPasses {
 public:
  /// After the pass has run. The time since the one before, such as that of uploads, counts for it.
  void ran(const gl::ComputePass& pass);
  /// Waits for the device.
  std::map<std::string, KernelTime> kernels() const;

 private:
  gl::Stopwatch stopwatch_;
  std::map<std::string, double> bytes_;
};

}  // namespace fascia
