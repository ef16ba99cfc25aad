#include "sim/fit/measured/unit.h"

#include <algorithm>
#include <iterator>

namespace fascia {
namespace {

constexpr Unit kUnits[] = {{"s", Dimension::time, 1},       {"ms", Dimension::time, 1e-3},
                           {"min", Dimension::time, 60},    {"N", Dimension::force, 1},
                           {"mN", Dimension::force, 1e-3},  {"kN", Dimension::force, 1e3},
                           {"m", Dimension::length, 1},     {"cm", Dimension::length, 1e-2},
                           {"mm", Dimension::length, 1e-3}, {"um", Dimension::length, 1e-6}};

}  // namespace

const Unit* find_unit(std::string_view name) {
  const auto found = std::find_if(std::begin(kUnits), std::end(kUnits), [&](const Unit& u) { return name == u.name; });
  return found == std::end(kUnits) ? nullptr : &*found;
}

std::string unit_names(Dimension dimension) {
  std::string names;
  for (const Unit& unit : kUnits)
    if (unit.dimension == dimension) names += (names.empty() ? "" : ", ") + std::string(unit.name);
  return names;
}

const char* si_unit(Dimension dimension) {
  return std::find_if(std::begin(kUnits), std::end(kUnits),
                      [&](const Unit& u) { return u.dimension == dimension && u.size == 1; })
      ->name;
}

}  // namespace fascia
