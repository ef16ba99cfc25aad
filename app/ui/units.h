// Formats numbers with units, "12.5 kPa", and parses typed ones.
#pragma once
#include <optional>
#include <string>

namespace fascia {

/// Three or four digits; an SI prefix for Pa, N, J, m, m/s and s, none for other units: "12.5 kPa", "1000 kg/m^3",
/// "0.3", "-".
std::string engineering(double value, const std::string& unit, int digits = 3);

/// "12.5 kPa", "12.5k", "3e4": a number, an optional prefix, an optional unit.
std::optional<double> parse_engineering(std::string text, const std::string& unit);

/// "1.4 MiB"
std::string bytes_text(double bytes);

}  // namespace fascia
