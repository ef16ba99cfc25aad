// All bodies of a model with more freedom, to be simulated beside it: linear tets become quadratic, quadratic ones are
// cut in eight and are quadratic again.
#pragma once
#include <cstdint>
#include <vector>

#include "sim/model/model.h"

namespace fascia {

struct RefinedBodies {
  Model model;                        // its surfaces and scripted grabs are left out
  std::vector<std::uint32_t> places;  // [vertex of the coarse model] its number
};

/// What is given at vertices, such as motions and initial velocities, follows the functions of the coarse tets; a new
/// vertex is held if both ends of its edge are. The tets of a body are of one kind.
RefinedBodies refined_bodies(const Model& coarse);

}  // namespace fascia
