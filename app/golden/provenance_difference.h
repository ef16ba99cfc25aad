// Explains why two pictures differ by comparing their provenance: the usual reason is another renderer, version, mesh
// or parameter.
#pragma once
#include <string>
#include <vector>

#include "sim/output/run_provenance.h"

namespace fascia {

/// A line for each difference, parameters by their path: "solver.iterations: golden 10, now 20". Empty: none. Command
/// lines are not compared, because they contain folders.
std::vector<std::string> provenance_differences(const Provenance& golden, const Provenance& now);

}  // namespace fascia
