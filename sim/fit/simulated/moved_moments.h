// What is observed in the scene at slightly other values of a parameter, to first order: by the tangents of
// its equilibria or of the stages of its motion (sim/reference/tangent/static_tangent.h, step_tangent.h), without
// another simulation.
#pragma once
#include <optional>
#include <vector>

#include "sim/fit/simulated/simulator.h"

namespace fascia {

/// The scene at p - step and p + step of a parameter.
struct ModelPair {
  Model below, above;
};
struct MomentPair {
  std::vector<Moment> below, above;
};

/// [pair] the moments of `course`, which `here` gave, in the scenes of each pair. None where a state has no tangent.
std::optional<std::vector<MomentPair>> moved_moments(const Course& course, const Model& here,
                                                     const std::vector<ModelPair>& pairs, double step);

}  // namespace fascia
