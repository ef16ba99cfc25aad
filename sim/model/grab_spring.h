// A spring that pulls a vertex to a target, as a grab does. Several grabs may pull at one vertex.
#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace fascia {

struct GrabSpring {
  std::uint32_t vertex;
  Eigen::Vector3d target;  // displacement the spring pulls to [m]
  double stiffness;        // [N/m]
  std::uint32_t grab = 0;  // whose spring it is
  bool operator==(const GrabSpring&) const = default;
};

/// Grabs of a scene's "grabs" count from here, those of the mouse from 0.
inline constexpr std::uint32_t kFirstScriptedGrab = 1u << 16;

/// One spring per vertex that pulls as all of a vertex together do: the sum of their stiffnesses, at the mean of their
/// targets that the stiffnesses weigh. In the order in which the vertices first appear; a vertex with one spring keeps
/// its numbers. `place` receives [springs.size()] where the spring went.
std::vector<GrabSpring> joined(const std::vector<GrabSpring>& springs, std::vector<std::uint32_t>& place);

struct GrabForce {
  std::uint32_t grab;
  Eigen::Vector3d force{0, 0, 0};  // on the tissue [N]
};

/// What each grab has of the forces [N] of joined springs, [joined.size()]: they add up to the whole, whoever solved
/// it. In the order in which the grabs first appear.
std::vector<GrabForce> forces_of_grabs(const std::vector<GrabSpring>& springs, const std::vector<GrabSpring>& joined,
                                       const std::vector<std::uint32_t>& place,
                                       const std::vector<Eigen::Vector3d>& forces);

/// The same from displacements [vertex_count] [m].
std::vector<GrabForce> forces_of_grabs(const std::vector<GrabSpring>& springs,
                                       const std::vector<Eigen::Vector3d>& displacement);

}  // namespace fascia
