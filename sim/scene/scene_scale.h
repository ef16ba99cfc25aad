// Converts a scene to another unit of length, for files that were made in millimeters.
#pragma once
#include "sim/scene/scene.h"

namespace fascia {

/// Multiplies all lengths, and so velocities, by `factor`: the bodies and their motions, grabs, the section plane, the
/// camera. Selections stay in the mesh's own coordinates, gravity and materials in SI. Throws Error, without changes,
/// if lengths are in a file.
void scale_lengths(Scene& scene, double factor);

}  // namespace fascia
