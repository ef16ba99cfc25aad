// Formats words and numbers for the reports about meshes and surfaces.
#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <iosfwd>
#include <string>

namespace fascia {

std::string number(double value);  // 4 digits
std::string plural(std::size_t count, const char* noun);
/// A length in its customary unit.
std::string length(double meters);
/// A length in the unit of a file: "60 mm". Those of files in meters are in their customary unit.
std::string length_in(const std::string& unit, double value);
std::string point(const Eigen::Vector3d& p);  // "(1, 2, 3)"
/// Begins a labeled line.
std::ostream& line(std::ostream& out, const std::string& label);

}  // namespace fascia
