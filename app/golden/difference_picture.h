// Shows two pictures and their difference side by side, for visual inspection.
#pragma once
#include "render/target/image.h"

namespace fascia {

/// Left the golden, in the middle the new picture, right the golden in dark gray with the differences: blue up to
/// `bound`, above it from red to yellow at the maximum. A magenta frame in all three encloses the pixels beyond the
/// bound. The pictures must have the same size.
Image difference_picture(const Image& golden, const Image& now, double bound);

}  // namespace fascia
