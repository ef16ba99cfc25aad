// Vertices as round dots: one instance each, a square that faces the camera, moved toward the camera by its radius so
// that the surface does not cut it.
#include "common/frame.glsl"
layout(location = 0) in uint vertex;
layout(binding = 0) uniform samplerBuffer positions;
uniform float radius;  // [points]
out vec2 offset;       // [pixels] from the center
flat out float radius_in_pixels;

void main() {
  vec3 p = texelFetch(positions, int(vertex)).xyz;
#if SECTION
  if (dot(frame.section.xyz, p) > frame.section.w) {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    return;
  }
#endif
  float depth = to_clip(p).w;
  float pixel = frame.picture.w * depth;  // [m]
  radius_in_pixels = min(radius * frame.picture.z, 0.03 * frame.center.w / pixel);
  vec3 to_eye = normalize(frame.eye.xyz - p);
  vec4 clip = to_clip(p + to_eye * pixel * (radius_in_pixels + 1.0));
  offset = (vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0) * (radius_in_pixels + 1.0);
  clip.xy += 2.0 * offset / frame.picture.xy * clip.w;
  gl_Position = clip;
}
