// The same scene in another unit of length: for one whose files were made in millimeters.
#pragma once
#include "sim/scene/scene.h"

namespace fascia {

/// All lengths times `factor`, and so velocities: the bodies and their motions, grabs, the section plane, the camera.
/// Selections are in the mesh's own coordinates, gravity and materials in SI; both stay. Throws Error, and changes
/// nothing, where a file has lengths.
void scale_lengths(Scene& scene, double factor);

}  // namespace fascia
