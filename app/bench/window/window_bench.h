// How a window feels: a session on a virtual screen with a grab, on a quiet machine and beside busy programs, with and
// without compiled kernels.
#pragma once
#include <string>

#include "app/bench/bench.h"

namespace fascia {

struct WindowBenchOptions : BenchOptions {
  std::vector<int> busy;  // programs beside it, one measurement each; empty: 0, 1, 2, 4
  std::string against;    // another build's program, measured in turn; empty: none
};

/// Writes window.csv. Throws Error or Interrupted.
void bench_window(Bench& bench, const WindowBenchOptions& options);

}  // namespace fascia
