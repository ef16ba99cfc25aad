// Converts the picture's depth to positions in view space [m]: x right, y up, z away from the camera.
#include "common/frame.glsl"
layout(binding = 0) uniform sampler2D depth;
uniform vec4 unproject;  // of the projection matrix: 1 / m00, 1 / m11, m22, m23
uniform vec4 occlusion;  // x reach [m], y strength; zw of the projection matrix: m02, m12

const float kNothing = 1.0;  // depth of pixels without geometry

float away(float d) { return unproject.w / (2.0 * d - 1.0 + unproject.z); }

vec3 view_place(ivec2 pixel) {
  float z = away(texelFetch(depth, clamp(pixel, ivec2(0), ivec2(frame.picture.xy) - 1), 0).x);
  return vec3((2.0 * (vec2(pixel) + 0.5) / frame.picture.xy - 1.0 + occlusion.zw) * unproject.xy, 1.0) * z;
}
