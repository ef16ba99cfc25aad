// The ground as nine cells: the middle one lies under the shadow map (SHADOW), the eight around it never see a shadow. Two
// triangles per cell.
#include "common/frame.glsl"
out vec3 place;
#if SHADOW
out vec2 shadow_position;
#endif
const float kReach = 1.8;  // of the outer cells, in sides of the middle one: beyond where the ground has faded

void main() {
  int cell = gl_VertexID / 6, corner = gl_VertexID % 6;
#if SHADOW
  vec2 low = vec2(0.0), high = vec2(1.0);
#else
  cell += cell / 4;  // skips the middle
  float lines[4] = float[4](-kReach, 0.0, 1.0, 1.0 + kReach);
  vec2 low = vec2(lines[cell % 3], lines[cell / 3]), high = vec2(lines[cell % 3 + 1], lines[cell / 3 + 1]);
#endif
  vec2 uv = mix(low, high, vec2(corner == 1 || corner == 2 || corner == 4, corner == 2 || corner == 4 || corner == 5));
  place = frame.ground_origin.xyz + uv.x * frame.ground_u.xyz + uv.y * frame.ground_v.xyz;
#if SHADOW
  shadow_position = uv;
#endif
  gl_Position = to_clip(place);
}
