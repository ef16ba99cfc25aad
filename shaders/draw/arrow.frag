// Draws shaft, head and foot of the arrow as one shape, defined by its distance in pixels, with a light border that
// separates it from the surface below.
#include "common/frame.glsl"
in vec2 pixel;
flat in vec2 start, end;
layout(location = 0) out vec4 color;

float to_segment(vec2 p, vec2 a, vec2 b) {
  vec2 ab = b - a, ap = p - a;
  return length(ap - ab * clamp(dot(ap, ab) / max(dot(ab, ab), 1e-6), 0.0, 1.0));
}

void main() {
  float point = frame.picture.z;
  vec2 along = end - start;
  float size = length(along);
  along = size > 1e-2 ? along / size : vec2(1.0, 0.0);
  float head = min(11.0 * point, size);
  vec2 local = vec2(dot(pixel - end, along), dot(pixel - end, vec2(-along.y, along.x)));  // x: beyond the tip
  float shape = to_segment(pixel, start, end - along * min(head, size)) - 1.4 * point;
  shape = min(shape, length(pixel - start) - 3.6 * point);
  // A triangle with its tip at the end: a pixel is inside if it is behind both flanks and the base.
  float flank = dot(vec2(local.x, abs(local.y)), vec2(0.41, 0.912));
  shape = min(shape, max(flank, -local.x - head));
  float border = clamp(0.5 + 1.6 * point - shape, 0.0, 1.0), fill = clamp(0.5 - shape, 0.0, 1.0);
  color = vec4(mix(vec3(1.0), vec3(0.98, 0.68, 0.10), fill), border * mix(0.85, 1.0, fill));
}
