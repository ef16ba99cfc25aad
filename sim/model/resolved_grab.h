// Springs that pull at vertices of a model along a path: a function of time only, so that steps from any state repeat
// to the bit.
#pragma once
#include <limits>
#include <span>
#include <vector>

#include "sim/model/grab_spring.h"
#include "sim/scene/scene_grab.h"

namespace fascia {

struct ResolvedGrab {
  std::vector<GrabSpring> grip;         // at rest: targets are zero
  std::vector<ScriptedGrab::Key> path;  // in seconds of the scene; one key at least
  bool smooth = false;
  double start = 0, release = std::numeric_limits<double>::infinity();  // [s]

  Eigen::Vector3d displacement(double t) const;  // of the springs' targets [m]
  double end() const;                            // [s] nothing changes after this time
};

/// Appends to `springs` those of all scripted grabs that act at the end of a step at time t [s].
std::vector<GrabSpring> with_grabs(std::vector<GrabSpring> springs, std::span<const ResolvedGrab> grabs, double t);
/// The same at the end of all paths, released or not: for static equilibria.
std::vector<GrabSpring> with_grabs_at_last(std::vector<GrabSpring> springs, std::span<const ResolvedGrab> grabs);

}  // namespace fascia
