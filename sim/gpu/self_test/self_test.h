// Whether a device computes what it should: every class of kernels on a box of 480 tets (162 quadratic ones) against
// double precision. For bug reports, and for results that nobody expects.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "gl/program.h"

namespace fascia {

/// A class of kernels, and how far its results were from those in double precision.
struct KernelCheck {
  std::string kernels;   // "elastic_force, gradient (squared)"
  double deviation = 0;  // RMS over the RMS of the expected values, or the largest relative one of some numbers
  double bound = 0;      // on it
  std::string failure;   // what ended the check before it had a result

  bool passed() const { return failure.empty() && deviation <= bound; }
  /// "predict is off by 0.5, expected at most 1e-06"
  std::string text() const;
};

/// Runs all checks, the kernels that others depend on first, and calls `news` after each. Waits for the GPU.
std::vector<KernelCheck> self_test(gl::ProgramCache& programs,
                                   const std::function<void(const KernelCheck&)>& news = {});

}  // namespace fascia
