// The rows of the self-test.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "gl/program.h"

namespace fascia {

struct KernelRow {
  std::string kernels;
  double bound;
  std::function<double(gl::ProgramCache&)> deviation;  // throws Error
};

/// Kernels alone, against their definitions.
std::vector<KernelRow> single_kernels();
/// All kernels of a method in whole steps, against Newton's method.
std::vector<KernelRow> whole_steps();

}  // namespace fascia
