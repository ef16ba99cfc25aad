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
  std::uint32_t grab = 0;  // the id of its grab
  bool operator==(const GrabSpring&) const = default;
};

/// Ids of a scene's "grabs" start here, those of the mouse at 0.
inline constexpr std::uint32_t kFirstScriptedGrab = 1u << 16;

/// One spring per vertex that is equivalent to all springs of that vertex: the sum of their stiffnesses, at the mean of
/// their targets weighted by stiffness. In the order in which the vertices first appear; a vertex with one spring keeps
/// its numbers. `place` receives, [springs.size()], the index of each spring's result.
std::vector<GrabSpring> joined(const std::vector<GrabSpring>& springs, std::vector<std::uint32_t>& place);

struct GrabForce {
  std::uint32_t grab;
  Eigen::Vector3d force{0, 0, 0};  // on the tissue [N]
};

/// The share of each grab in the forces [N] of joined springs, [joined.size()]: the shares add up to the whole for any
/// solver. In the order in which the grabs first appear.
std::vector<GrabForce> forces_of_grabs(const std::vector<GrabSpring>& springs, const std::vector<GrabSpring>& joined,
                                       const std::vector<std::uint32_t>& place,
                                       const std::vector<Eigen::Vector3d>& forces);

/// The same from displacements [vertex_count] [m].
std::vector<GrabForce> forces_of_grabs(const std::vector<GrabSpring>& springs,
                                       const std::vector<Eigen::Vector3d>& displacement);

}  // namespace fascia
