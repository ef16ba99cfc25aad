// How much key light reaches the ground, for every point under the shadow map, in the shadow map's own coordinates. Small and
// blurred, so the ground itself needs one lookup per pixel. A lamp with a size: the higher the body is above the ground,
// the wider its shadow's edge (two passes over the same neighbourhood: mean height of what is in the way, then its share).
#include "common/frame.glsl"
layout(binding = 0) uniform sampler2D shadow_map;
in vec2 place;
layout(location = 0) out vec4 light;

vec2 tap(int i, int count) {
  return sqrt((float(i) + 0.5) / float(count)) * vec2(cos(2.39996 * float(i)), sin(2.39996 * float(i)));
}

void main() {
  float depth = frame.ground_origin.w + place.x * frame.ground_u.w + place.y * frame.ground_v.w;
  const float widest = 0.055, narrowest = 0.006;
  float height = 0.0, blockers = 0.0;
  for (int i = 0; i < 12; ++i) {
    float above = depth - texture(shadow_map, place + widest * tap(i, 12)).x;
    float blocks = above > 0.0 ? 1.0 : 0.0;
    height += blocks * above;
    blockers += blocks;
  }
  float radius = clamp(PENUMBRA * height / max(blockers, 1.0), narrowest, widest);
  float blocked = 0.0;
  for (int i = 0; i < 20; ++i) blocked += depth > texture(shadow_map, place + radius * tap(i, 20)).x ? 1.0 : 0.0;
  light = vec4(1.0 - blocked / 20.0);
}
