// Finds where a scene's scripted grabs take hold of a model.
#pragma once
#include <cstddef>

#include "sim/model/resolved_grab.h"

namespace fascia {

struct Model;
struct Scene;

/// No grab is faster than that of the mouse: what a script asks for sooner is there later, so that a jump cannot tear
/// the tissue.
inline constexpr double kGrabSpeed = 10;  // scene radii per second

/// Finds the vertices of scene.grabs[index] in the model. Throws Error where there is no tissue near "at", nothing free
/// to hold, or no such body.
ResolvedGrab resolve_grab(const Scene& scene, std::size_t index, const Model& model);

}  // namespace fascia
