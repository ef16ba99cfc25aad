// Units of measured values, as the names of columns end in them: "reaction_y_mN".
#pragma once
#include <string>
#include <string_view>

namespace fascia {

enum class Dimension { time, force, length };

struct Unit {
  const char* name;
  Dimension dimension;
  double size;  // in s, N or m
};

const Unit* find_unit(std::string_view name);  // null: unknown
std::string unit_names(Dimension dimension);   // "N, mN, kN"
const char* si_unit(Dimension dimension);      // "s", "N", "m"

}  // namespace fascia
