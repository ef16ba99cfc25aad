// Finds the vertices that a scene's scripted grabs pull.
#pragma once
#include <cstddef>

#include "sim/model/resolved_grab.h"

namespace fascia {

struct Model;
struct Scene;

/// The largest speed of any grab, as for the mouse: a script that asks for more is followed later, so that a jump
/// cannot tear the tissue.
inline constexpr double kGrabSpeed = 10;  // scene radii per second

/// Finds the vertices of scene.grabs[index] in the model. Throws Error where there is no tissue near "at", no free
/// vertex to pull, or no such body.
ResolvedGrab resolve_grab(const Scene& scene, std::size_t index, const Model& model);

}  // namespace fascia
