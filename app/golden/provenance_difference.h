// Why two pictures differ, as far as their provenance tells: another renderer, version, mesh or parameter is the usual
// reason.
#pragma once
#include <string>
#include <vector>

#include "sim/output/run_provenance.h"

namespace fascia {

/// A line for each that differs, parameters by their path: "solver.iterations: golden 10, now 20". Empty: none does.
/// Command lines are not compared, for they name folders.
std::vector<std::string> provenance_differences(const Provenance& golden, const Provenance& now);

}  // namespace fascia
