#include "sim/model/grab_spring.h"

#include <algorithm>
#include <unordered_map>

namespace fascia {

std::vector<GrabSpring> joined(const std::vector<GrabSpring>& springs, std::vector<std::uint32_t>& place) {
  std::vector<GrabSpring> result;
  std::unordered_map<std::uint32_t, std::uint32_t> slot_of;
  place.clear();
  for (const GrabSpring& spring : springs) {
    const auto [slot, is_new] = slot_of.emplace(spring.vertex, static_cast<std::uint32_t>(result.size()));
    place.push_back(slot->second);
    if (is_new) {
      result.push_back(spring);
      continue;
    }
    GrabSpring& sum = result[slot->second];
    const double stiffness = sum.stiffness + spring.stiffness;
    if (stiffness > 0) sum.target += spring.stiffness / stiffness * (spring.target - sum.target);
    sum.stiffness = stiffness;
  }
  return result;
}

namespace {

GrabForce& entry(std::vector<GrabForce>& forces, std::uint32_t grab) {
  const auto known = std::find_if(forces.begin(), forces.end(), [&](const GrabForce& f) { return f.grab == grab; });
  return known != forces.end() ? *known : forces.emplace_back(GrabForce{grab});
}

}  // namespace

std::vector<GrabForce> forces_of_grabs(const std::vector<GrabSpring>& springs, const std::vector<GrabSpring>& joined,
                                       const std::vector<std::uint32_t>& place,
                                       const std::vector<Eigen::Vector3d>& forces) {
  std::vector<GrabForce> result;
  for (std::size_t i = 0; i < springs.size(); ++i) {
    const GrabSpring &part = springs[i], &whole = joined[place[i]];
    // k_j (t_j - u), with the u at which the joined spring has its force: K (T - u) = F.
    const double share = whole.stiffness > 0 ? part.stiffness / whole.stiffness : 0;
    entry(result, part.grab).force += share * forces[place[i]] + part.stiffness * (part.target - whole.target);
  }
  return result;
}

std::vector<GrabForce> forces_of_grabs(const std::vector<GrabSpring>& springs,
                                       const std::vector<Eigen::Vector3d>& displacement) {
  std::vector<GrabForce> result;
  for (const GrabSpring& s : springs) entry(result, s.grab).force += s.stiffness * (s.target - displacement[s.vertex]);
  return result;
}

}  // namespace fascia
