// The share of the key light that reaches a point on tissue. The shadow map is 1 where nothing is in the light's way.
#if SHADOW && CONTACT_SHADOW
// Percentage-closer soft shadows (Fernando 2005): the mean depth of what is in the light's way gives the width of the
// shadow's edge. Taps are compared with the plane of the surface instead of its depth (Isidoro 2006), so that a wide
// edge does not shadow the surface itself.
in vec3 shadow_position;
layout(binding = 0) uniform sampler2D shadow_map;

const int kSearch = 8, kTaps = 16;  // of four texels each
const float kWidest = 0.05, kNarrowest = 1.2 / SHADOW_SIZE;  // radius, in sides of the map

vec2 disc(int i, int count) {
  return sqrt((float(i) + 0.5) / float(count)) * vec2(cos(2.39996 * float(i)), sin(2.39996 * float(i)));
}

float key_visibility(vec3 n) {
  vec3 across = frame.light_projection[0].xyz * n.x + frame.light_projection[1].xyz * n.y +
                frame.light_projection[2].xyz * n.z;
  vec2 slope = SHADOW_FLATNESS * across.xy / max(-across.z, 0.2 * length(across));
  float z = shadow_position.z;
  float sum = 0.0, count = 0.0;
  for (int i = 0; i < kSearch; ++i) {
    vec2 offset = kWidest * disc(i, kSearch);
    vec4 depth = textureGather(shadow_map, shadow_position.xy + offset);
    float limit = min(z + dot(slope, offset), 1.0) - 0.002;
    vec4 blocks = step(depth, vec4(limit));
    count += dot(blocks, vec4(1.0));
    sum += dot(blocks, limit - depth);
  }
  if (count == 0.0) return 1.0;
  float radius = clamp(PENUMBRA * sum / count, kNarrowest, kWidest), lit = 0.0;
  for (int i = 0; i < kTaps; ++i) {
    vec2 offset = radius * disc(i, kTaps), at = shadow_position.xy + offset;
    vec4 open = step(vec4(min(z + dot(slope, offset), 1.0)), textureGather(shadow_map, at));
    vec2 share = fract(at * SHADOW_SIZE - 0.5);
    vec2 low = mix(open.wx, open.zy, share.x);  // gathered from the lower row, from the upper one
    lit += mix(low.x, low.y, share.y);
  }
  return lit / float(kTaps);
}
#elif SHADOW
in vec3 shadow_position;
layout(binding = 0) uniform sampler2DShadow shadow_map;

float key_visibility(vec3 n) {
  const float reach = 1.75 / SHADOW_SIZE;
  float sum = 0.0;
  for (int i = 0; i < SHADOW_TAPS; ++i) {
    float angle = 2.39996 * float(i), radius = reach * sqrt((float(i) + 0.5) / SHADOW_TAPS);
    vec2 at = shadow_position.xy + radius * vec2(cos(angle), sin(angle));
    sum += texture(shadow_map, vec3(at, min(shadow_position.z, 1.0)));
  }
  return sum / SHADOW_TAPS;
}
#else
float key_visibility(vec3 n) { return 1.0; }
#endif
