// A scene's scripted hand on the vertices of a model: its springs at any time. A function of time alone, so that steps repeat to the
// bit from wherever they start.
#pragma once
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "sim/grab_spring.h"
#include "sim/scene_grab.h"

namespace fascia {

struct Model;
struct Scene;

struct ScriptedHand {
  std::vector<GrabSpring> grip;  // at rest: targets are zero
  std::vector<ScriptedGrab::Key> path;  // in seconds of the scene; one key at least
  bool smooth = false;
  double start = 0, release = std::numeric_limits<double>::infinity();  // [s]

  Eigen::Vector3d displacement(double t) const;  // of the springs' targets [m]
  double end() const;  // [s] from then on nothing changes
};

/// No hand is faster than that of the mouse: what a script asks for sooner is there later, so that a jump cannot tear the tissue.
inline constexpr double kHandSpeed = 10;  // scene radii per second

/// Finds the vertices of scene.grabs[index] in the model. Throws Error where there is no tissue near "at", nothing free to hold, or
/// no such body.
ScriptedHand resolve_hand(const Scene& scene, std::size_t index, const Model& model);

/// Springs of all hands of the script that hold at the end of a step at time t [s], after those of others.
std::vector<GrabSpring> with_hands(std::vector<GrabSpring> springs, std::span<const ScriptedHand> hands, double t);
/// As they are in the end, whether they would have let go or not: for static equilibria.
std::vector<GrabSpring> with_hands_at_last(std::vector<GrabSpring> springs, std::span<const ScriptedHand> hands);

}  // namespace fascia
