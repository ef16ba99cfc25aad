// The golden forces of contact: a CSV beside that of the state, for scenes with tools.
#pragma once
#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace fascia {

using ContactForces = std::vector<std::pair<std::string, Eigen::Vector3d>>;  // [tool] its name, its force on tissue [N]

/// NAME.contact.csv of NAME.csv.
std::filesystem::path contact_beside(const std::filesystem::path& state);
/// Rows `force_x_N,force_y_N,force_z_N,tool`. Throw Error.
void write_contact_golden(const std::filesystem::path& path, const ContactForces& forces);
ContactForces read_contact_golden(const std::filesystem::path& path);
/// Nothing if both have the same tools in the same order, else the names of either.
std::string differing_tools(const ContactForces& forces, const ContactForces& golden);
/// The largest difference of a force over the largest golden one: infinite if the tools differ, or if a force is where
/// there was none.
double contact_deviation(const ContactForces& forces, const ContactForces& golden);

}  // namespace fascia
