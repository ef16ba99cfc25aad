// The cover between the light and the ground, for points of the shadow map at lower resolution: the share that is
// covered, and the mean height of the cover above the ground (as depth along the light), weighted by that share.
#include "common/frame.glsl"
layout(binding = 0) uniform sampler2D shadow_map;
in vec2 place;
layout(location = 0) out vec4 cover;

void main() {
  // 1 where nothing is in the light's way: below a body far above it, the ground may lie beyond.
  float depth = min(frame.ground_origin.w + place.x * frame.ground_u.w + place.y * frame.ground_v.w, 1.0);
  vec4 share = vec4(0.0), height = vec4(0.0);
  const float quarter = 0.25 / GROUND_SIZE;  // of a texel: four gathers of 2 x 2 are spread over it
  for (int i = 0; i < 4; ++i) {
    vec2 at = place + quarter * vec2((i & 1) * 2 - 1, (i >> 1) * 2 - 1);
    vec4 above = depth - textureGather(shadow_map, at);
    share += step(1e-6, above);
    height += max(above, 0.0);
  }
  cover = vec4(dot(share, vec4(1.0 / 16.0)), dot(height, vec4(1.0 / 16.0)), 0.0, 1.0);
}
