// Parses tolerances in their usual notations: 0.002, 2e-3, 0.5/255.
#pragma once
#include <string>
#include <string_view>

namespace fascia {

/// A share from 0 to 1. Throws Error naming `where`.
double parse_tolerance(std::string_view text, const std::string& where);

/// "0.00196": three digits, as findings print measured values.
std::string three_digits(double value);

}  // namespace fascia
