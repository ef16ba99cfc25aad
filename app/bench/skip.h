// fascia bench skip: the cost of every feature that a scene may do without, when it was never there, when it has been
// switched off, and on.
#pragma once
#include <string>
#include <vector>

#include "app/bench/bench.h"

namespace fascia {

/// Writes skip.csv. Returns the lines that name what costs something although it is off. Throws Error or Interrupted.
std::vector<std::string> bench_skip(Bench& bench);

}  // namespace fascia
