// Makes goldens of a run, and measures how much it amplifies rounding.
#pragma once
#include "app/golden/sensitivity.h"
#include "app/headless/headless.h"

namespace fascia {

/// Repeats the run that led to this outcome, from a mesh that is moved by rounding. No other Headless may exist. Throws
/// Error.
Sensitivity measure_sensitivity(const RenderOptions& options, const Outcome& outcome);

/// Replaces the goldens of the options by the outcome, and their sensitivity by that of a second run. Describes each
/// change in a line. Throws Error.
std::vector<std::string> renew_goldens(const RenderOptions& options, const Outcome& outcome);

}  // namespace fascia
