// Times that the device tells (GL_TIMESTAMP).
#pragma once
#include "gl/loader.h"

namespace fascia::gl {

/// From one timestamp to a later one [ms], of a counter with so many bits, which begins anew after the last: with the
/// 36 of some drivers every 69 s. 0 where the later one is the smaller one although the counter has all 64: a driver
/// that did not say how many it has.
double milliseconds_between(GLuint64 from, GLuint64 to, int bits = device().timestamp_bits);

}  // namespace fascia::gl
