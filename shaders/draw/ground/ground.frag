// The ground: a pale floor with a grid of fine and strong lines, both fading into the background with the distance from
// the scene, so that there is no horizon. On a transparent backdrop only the shadow is drawn.
#include "common/frame.glsl"
#include "common/background.glsl"
in vec3 place;
in vec2 grid;
#if SHADOW
in vec2 shadow_position;
layout(binding = 0) uniform sampler2D ground_light;
#endif
layout(location = 0) out vec4 color;

#if BACKDROP_BLACK
const vec3 kFloor = vec3(0.10, 0.105, 0.115), kLine = vec3(0.27, 0.285, 0.30);
#else
const vec3 kFloor = vec3(0.885, 0.89, 0.90), kLine = vec3(0.55, 0.58, 0.62);
#endif

void main() {
  float presence = max(1.0 - dot(place, place) * (1.0 / 49.0), 0.0);
  presence *= presence;
#if BACKDROP_TRANSPARENT
  color = vec4(0.0, 0.0, 0.0, 0.45 * presence * (1.0 - texture(ground_light, shadow_position).x));
#else
  // The nearest line of each family: its share of the pixel, fading where lines come closer than a few pixels; every
  // grid_z.w-th is strong, which also lets it fade later.
  vec2 nearest = floor(grid + 0.5), width = fwidth(grid);
  vec2 weak = step(0.5, abs(fract(nearest * frame.grid_z.w + 0.5) - 0.5) / frame.grid_z.w);
  vec2 thick = 0.5 + frame.picture.z * mix(vec2(0.7), vec2(0.5), weak);
  vec2 share = clamp(thick - abs(grid - nearest) / width, 0.0, 1.0);
  vec2 strength = mix(vec2(0.6), vec2(0.3), weak) * clamp(1.6 - (2.5 + 2.5 * weak) * width, 0.0, 1.0);
  vec2 lines = share * strength;
  vec3 result = mix(kFloor, kLine, max(lines.x, lines.y));
#if SHADOW
  result *= mix(vec3(0.50, 0.53, 0.58), vec3(1.0), texture(ground_light, shadow_position).x);
#endif
  result = mix(background(gl_FragCoord.y / frame.picture.y), result, presence);
#if BACKDROP_WHITE || BACKDROP_BLACK
  color = vec4(result + clamp(20.0 * presence, 0.0, 1.0) * dither(gl_FragCoord.xy), 1.0);
#else
  color = vec4(result + dither(gl_FragCoord.xy), 1.0);
#endif
#endif
}
