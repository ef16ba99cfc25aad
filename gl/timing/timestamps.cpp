#include "gl/timing/timestamps.h"

namespace fascia::gl {

double milliseconds_between(GLuint64 from, GLuint64 to, int bits) {
  if (bits >= 64) return to < from ? 0 : static_cast<double>(to - from) * 1e-6;
  return static_cast<double>((to - from) & ((GLuint64{1} << bits) - 1)) * 1e-6;
}

}  // namespace fascia::gl
