// The ground as nine cells of two triangles: eight that never receive a shadow around the one under the shadow map,
// which is the last. SHADOW draws only that one.
#include "common/frame.glsl"
out vec3 place;  // from the scene's center, in its radii
out vec2 grid;  // place in fine lines
#if SHADOW
out vec2 shadow_position;
#endif
invariant gl_Position;  // the cells of both programs share edges
const float kReach = 1.8;  // of the outer cells, in sides of the middle one: the ground has faded out there

void main() {
  int cell = gl_VertexID / 6, corner = gl_VertexID % 6;
  cell = cell == 8 ? 4 : cell + cell / 4;
  float lines[4] = float[4](-kReach, 0.0, 1.0, 1.0 + kReach);
  vec2 low = vec2(lines[cell % 3], lines[cell / 3]), high = vec2(lines[cell % 3 + 1], lines[cell / 3 + 1]);
  bvec2 far = bvec2(corner == 1 || corner == 2 || corner == 4, corner == 2 || corner == 4 || corner == 5);
  vec2 uv = mix(low, high, far);
  vec3 world = frame.ground_origin.xyz + uv.x * frame.ground_u.xyz + uv.y * frame.ground_v.xyz;
  place = (world - frame.center.xyz) / frame.center.w;
  grid = vec2(dot(world, frame.grid_x.xyz), dot(world, frame.grid_z.xyz)) / frame.grid_x.w;
#if SHADOW
  shadow_position = uv;
#endif
  gl_Position = to_clip(world);
}
