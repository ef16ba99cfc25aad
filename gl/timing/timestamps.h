// Times measured by the device (GL_TIMESTAMP).
#pragma once
#include "gl/loader.h"

namespace fascia::gl {

/// From one timestamp to a later one [ms], for a counter of `bits` that wraps around: every 69 s with the 36 bits of
/// some drivers. 0 if the later one is smaller although the counter has all 64 bits: such a driver does not report its
/// number of bits.
double milliseconds_between(GLuint64 from, GLuint64 to, int bits = device().timestamp_bits);

}  // namespace fascia::gl
