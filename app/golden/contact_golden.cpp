#include "app/golden/contact_golden.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "base/error.h"
#include "base/file.h"
#include "base/number_text.h"

namespace fascia {
namespace {

constexpr const char* kHeader = "force_x_N,force_y_N,force_z_N,tool";

// The name is last, since it may hold a comma.
std::string one_line(std::string name) {
  std::replace(name.begin(), name.end(), '\n', ' ');
  return name;
}

}  // namespace

std::filesystem::path contact_beside(const std::filesystem::path& state) {
  return std::filesystem::path(state).replace_extension(".contact" + state.extension().string());
}

void write_contact_golden(const std::filesystem::path& path, const ContactForces& forces) {
  NumberText out;
  out.add(kHeader).add('\n');
  for (const auto& [name, force] : forces)
    out.add(force.x()).add(',').add(force.y()).add(',').add(force.z()).add(',').add(one_line(name)).add('\n');
  write_file(path, out.take());
}

ContactForces read_contact_golden(const std::filesystem::path& path) {
  std::istringstream in(read_file(path));
  ContactForces forces;
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    if (number == 1 && line == kHeader) continue;
    std::istringstream row(line);
    Eigen::Vector3d force;
    char comma = ',';
    for (int k = 0; k < 3 && comma == ','; ++k) row >> force[k] >> comma;
    std::string name;
    if (!row || comma != ',' || !std::getline(row, name))
      throw Error(path.string() + ":" + std::to_string(number), "is no row of a tool",
                  std::string("expected ") + kHeader);
    forces.emplace_back(name, force);
  }
  return forces;
}

std::string differing_tools(const ContactForces& forces, const ContactForces& golden) {
  const auto names = [](const ContactForces& tools) {
    std::string list;
    for (const auto& [name, force] : tools) list += (list.empty() ? "" : ", ") + one_line(name);
    return list.empty() ? "none" : list;
  };
  const auto same = [](const auto& a, const auto& b) { return one_line(a.first) == b.first; };
  if (std::equal(forces.begin(), forces.end(), golden.begin(), golden.end(), same)) return {};
  return "golden " + names(golden) + "; now " + names(forces);
}

double contact_deviation(const ContactForces& forces, const ContactForces& golden) {
  constexpr double kOther = std::numeric_limits<double>::infinity();
  if (!differing_tools(forces, golden).empty()) return kOther;
  double largest = 0, difference = 0;
  for (std::size_t t = 0; t < forces.size(); ++t) {
    if (!forces[t].second.allFinite()) return kOther;
    largest = std::max(largest, golden[t].second.norm());
    difference = std::max(difference, (forces[t].second - golden[t].second).norm());
  }
  if (difference == 0) return 0;
  return largest > 0 ? difference / largest : kOther;
}

}  // namespace fascia
