#include "base/text.h"

#include <array>
#include <cstdio>
#include <ostream>
#include <string_view>

namespace fascia {

std::string number(double value) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.4g", value);
  return text.data();
}

std::string plural(std::size_t count, const char* noun) {
  if (count != 1 && std::string_view(noun) == "vertex") return std::to_string(count) + " vertices";
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string length(double meters) {
  struct Unit {
    double size;
    const char* name;
  };
  constexpr Unit kUnits[] = {{1e3, "km"}, {1, "m"}, {1e-3, "mm"}, {1e-6, "um"}};
  for (const Unit& unit : kUnits) {
    if (meters >= unit.size) return number(meters / unit.size) + " " + unit.name;
  }
  return number(meters) + " m";
}

std::string length_in(const std::string& unit, double value) {
  return unit == "m" ? length(value) : number(value) + " " + unit;
}

std::string point(const Eigen::Vector3d& p) {
  return "(" + number(p.x()) + ", " + number(p.y()) + ", " + number(p.z()) + ")";
}

std::ostream& line(std::ostream& out, const std::string& label) {
  constexpr std::size_t kWidth = 12;
  return out << label << std::string(label.size() < kWidth ? kWidth - label.size() : 1, ' ');
}

}  // namespace fascia
