// The uniform block that all drawing programs of one picture share.
layout(std140, binding = 0) uniform Frame {
#include "shared/frame.h"
} frame;

vec4 to_clip(vec3 p) {
  return frame.view_projection[0] * p.x + frame.view_projection[1] * p.y + frame.view_projection[2] * p.z +
         frame.view_projection[3];
}

vec3 to_shadow(vec3 p) {
  return (frame.light_projection[0] * p.x + frame.light_projection[1] * p.y +
          frame.light_projection[2] * p.z + frame.light_projection[3]).xyz;
}
