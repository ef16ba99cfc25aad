// The grab spring: a square in the picture around the segment from the grabbed patch to the mouse.
#include "common/frame.glsl"
uniform vec4 from, to;  // xyz [m]
out vec2 pixel;
flat out vec2 start, end;
const float kMargin = 12.0;  // [points]: room for the arrow head and the border

vec2 in_pixels(vec4 clip) { return (0.5 + 0.5 * clip.xy / max(clip.w, 1e-6)) * frame.picture.xy; }

void main() {
  start = in_pixels(to_clip(from.xyz));
  end = in_pixels(to_clip(to.xyz));
  vec2 along = end - start;
  along = dot(along, along) > 1e-4 ? normalize(along) : vec2(1.0, 0.0);
  vec2 across = vec2(-along.y, along.x);
  float margin = kMargin * frame.picture.z;
  pixel = (gl_VertexID & 1) == 0 ? start - along * margin : end + along * margin;
  pixel += across * ((gl_VertexID >> 1) == 0 ? -margin : margin);
  gl_Position = vec4(2.0 * pixel / frame.picture.xy - 1.0, 0.0, 1.0);
}
