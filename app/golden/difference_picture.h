// Where two pictures differ and how much, for people: both, and the difference beside them.
#pragma once
#include "render/target/image.h"

namespace fascia {

/// Left the golden, in the middle the new picture, right the golden in dark gray with what differs on it: blue up to
/// `bound`, from red at it to yellow where it is most. A magenta frame in all three holds the pixels beyond the bound.
/// Pictures of one size.
Image difference_picture(const Image& golden, const Image& now, double bound);

}  // namespace fascia
