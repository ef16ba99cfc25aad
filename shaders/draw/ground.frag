// The ground: a pale floor with a grid of fine and strong lines, both fading into the background with the distance from the
// scene, so that there is no horizon.
#include "common/frame.glsl"
#include "common/background.glsl"
in vec3 place;
#if SHADOW
in vec2 shadow_position;
layout(binding = 0) uniform sampler2D ground_light;
#endif
layout(location = 0) out vec4 color;

// Share of the pixel that lines at whole numbers cover; `width` is the pixel's extent, lines are `thick` pixels wide. Where
// lines come closer than pixels they fade away.
vec2 lines(vec2 at, vec2 width, float thick) {
  vec2 distance = abs(fract(at + 0.5) - 0.5) / width;
  return clamp(0.5 * thick + 0.5 - distance, 0.0, 1.0) * clamp(1.6 - 4.0 * width, 0.0, 1.0);
}

void main() {
  vec3 from_center = place - frame.center.xyz;
  float away = dot(from_center, from_center) / (frame.center.w * frame.center.w);
  float presence = max(1.0 - away * (1.0 / 49.0), 0.0);
  presence *= presence;
  vec2 at = vec2(dot(place, frame.grid_x.xyz), dot(place, frame.grid_z.xyz)) / frame.grid_x.w;
  vec2 width = sqrt(dFdx(at) * dFdx(at) + dFdy(at) * dFdy(at));
  vec2 fine = lines(at, width, 1.0 * frame.picture.z);
  vec2 strong = lines(at / frame.grid_z.w, width / frame.grid_z.w, 1.4 * frame.picture.z);
  float line = max(0.30 * max(fine.x, fine.y), 0.60 * max(strong.x, strong.y));
  vec3 result = mix(vec3(0.885, 0.89, 0.90), vec3(0.55, 0.58, 0.62), line);
#if SHADOW
  result *= mix(vec3(0.50, 0.53, 0.58), vec3(1.0), texture(ground_light, shadow_position).x);
#endif
  result = mix(background(gl_FragCoord.y / frame.picture.y), result, presence);
  color = vec4(result + dither(gl_FragCoord.xy), 1.0);
}
