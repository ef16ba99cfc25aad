// The result of a fit as lines of text, and what report and command say alike.
#pragma once
#include <string>

#include "sim/fit/fit.h"

namespace fascia {

/// The unit of a parameter, "Pa"; empty: none known.
std::string unit_of(const std::string& key);
/// "11800 to 12270"; "not determined" by the measurement; "unknown", where the noise is.
std::string interval_text(const Estimate& estimate);
/// "1.02 % of the largest values", or with a known noise "1.02 times the noise".
std::string misfit_text(double misfit, bool noise_known);
/// "9 simulations (rates by implicit differentiation), 12 for the profile".
std::string effort_text(const FitResult& result);
/// Parameters with their intervals, correlations, residual, effort and warnings, for standard output.
std::string fit_text(const FitResult& result, bool noise_known);

}  // namespace fascia
