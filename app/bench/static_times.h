// fascia bench static: time and iterations to the static equilibrium, from 5,000 to a million tets.
#pragma once
#include "app/bench/bench.h"

namespace fascia {

/// Writes static.csv. Throws Error or Interrupted.
void bench_static(Bench& bench);

}  // namespace fascia
