// The two charts of a case of `fascia bench accuracy`.
#pragma once
#include "app/bench/accuracy/results.h"
#include "app/bench/bench.h"

namespace fascia {

/// Error against iterations and against time, as files named after the case. Only the best acceleration of each method
/// and the solver choice of the I3D 2019 paper have a line; the Pareto frontier is that of all choices. Throws Error.
void draw_charts(const Bench& bench, const CaseAccuracy& result);

}  // namespace fascia
