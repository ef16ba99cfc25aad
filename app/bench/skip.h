// fascia bench skip: the cost of every optional feature, in three states: never on, switched off, and on.
#pragma once
#include <string>
#include <vector>

#include "app/bench/bench.h"

namespace fascia {

/// Writes skip.csv. Returns a line for each feature that costs time although it is off. Throws Error or Interrupted.
std::vector<std::string> bench_skip(Bench& bench);

}  // namespace fascia
