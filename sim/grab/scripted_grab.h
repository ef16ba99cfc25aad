// Finds where a scene's scripted hands take hold of a model.
#pragma once
#include <cstddef>

#include "sim/model/scripted_hand.h"

namespace fascia {

struct Model;
struct Scene;

/// No hand is faster than that of the mouse: what a script asks for sooner is there later, so that a jump cannot tear
/// the tissue.
inline constexpr double kHandSpeed = 10;  // scene radii per second

/// Finds the vertices of scene.grabs[index] in the model. Throws Error where there is no tissue near "at", nothing free
/// to hold, or no such body.
ScriptedHand resolve_hand(const Scene& scene, std::size_t index, const Model& model);

}  // namespace fascia
