// Lights the surface: key light with a soft shadow, sky and ground light, a gentle highlight and rim. A CAP, the cut of
// a section plane, is not a surface of the tissue: its color does not depend on the light.
#include "common/frame.glsl"
#include "common/color.glsl"
#include "common/heat.glsl"
#if DEPTH_CUE
#include "common/background.glsl"
#endif
in vec3 to_eye;
in vec3 surface_normal;
#if BASE_COLOR
in vec4 own_color;  // a 0: use the color of the look
#endif
#if HEAT_MAP
in float heat;
#endif
#if SHADOW
in vec3 shadow_position;
layout(binding = 0) uniform sampler2DShadow shadow_map;
#endif
#if WIREFRAME
in vec3 barycentric;
#endif
#if REGIONS
layout(binding = 4) uniform usamplerBuffer region;  // per item of TRIANGLES triangles
#endif
layout(location = 0) out vec4 color;

float key_visibility() {
#if SHADOW
  const float reach = 1.75 / SHADOW_SIZE;
  float sum = 0.0;
  for (int i = 0; i < SHADOW_TAPS; ++i) {
    float angle = 2.39996 * float(i), radius = reach * sqrt((float(i) + 0.5) / SHADOW_TAPS);
    vec2 at = shadow_position.xy + radius * vec2(cos(angle), sin(angle));
    sum += texture(shadow_map, vec3(at, shadow_position.z));
  }
  return sum / SHADOW_TAPS;
#else
  return 1.0;
#endif
}

#if WIREFRAME
// Share of the pixel covered by an edge of the triangle; fades out where triangles are only a few pixels high.
float edge_coverage() {
  vec3 per_pixel = sqrt(dFdx(barycentric) * dFdx(barycentric) + dFdy(barycentric) * dFdy(barycentric));
  vec3 distance = barycentric / per_pixel;
  float nearest = min(distance.x, min(distance.y, distance.z));
  float height = 1.0 / max(per_pixel.x, max(per_pixel.y, per_pixel.z));
  float half_width = 0.55 * frame.picture.z;
  return clamp(half_width + 0.5 - nearest, 0.0, 1.0) * clamp(height / (10.0 * half_width), 0.0, 1.0);
}
#endif

vec3 base_color() {
#if REGIONS
  return frame.region_color[texelFetch(region, gl_PrimitiveID / TRIANGLES).x & 7u].rgb;
#elif CAP
  return mix(frame.base_color.rgb, vec3(1.0, 0.72, 0.62), 0.35);  // tissue is paler inside
#else
#if BASE_COLOR
  vec3 tissue = mix(frame.base_color.rgb, own_color.rgb, own_color.a);
#else
  vec3 tissue = frame.base_color.rgb;
#endif
  return gl_FrontFacing ? tissue : tissue.brg * 0.6;
#endif
}

vec3 shaded() {
#if CAP
#if HEAT_MAP
  return heat_color(heat);
#else
  return linear_to_srgb(0.92 * base_color());
#endif
#else
  vec3 n = normalize(gl_FrontFacing ? surface_normal : -surface_normal);
  vec3 l = frame.light.xyz;
  float n_l = dot(n, l), n_up = dot(n, frame.up.xyz), n_v = max(dot(n, to_eye), 0.0);
  float key = max((n_l + 0.15) / 1.15, 0.0) * mix(1.0, key_visibility(), clamp(4.0 * n_l + 0.5, 0.0, 1.0));
  float sky = 0.5 + 0.5 * n_up;
#if HEAT_MAP
  // The color encodes a number: light only darkens it, and full light shows the color bar's own color.
  float shade = min(0.30 + 0.22 * sky + 0.62 * key, 1.0);
  return heat_color(heat) * linear_to_srgb(vec3(shade)).x;
#else
  vec3 ambient = mix(vec3(0.27, 0.24, 0.23), vec3(0.38, 0.43, 0.50), sky);
  vec3 light = vec3(0.88, 0.84, 0.79) * key + ambient;
  float n_h = max(dot(n, normalize(l + to_eye)), 0.0);
  float gloss = n_h * n_h;
  gloss *= gloss;
  gloss *= gloss;
  gloss *= gloss;
  gloss *= gloss;
  float rim = (1.0 - n_v) * (1.0 - n_v);
  rim *= rim * (0.25 + 0.75 * sky);
  return display(base_color() * light + vec3(0.16) * gloss * key + vec3(0.15, 0.17, 0.20) * rim);
#endif
#endif
}

void main() {
  vec3 result = shaded();
#if WIREFRAME
  result = mix(result, result * 0.25, 0.8 * edge_coverage());
#endif
#if DEPTH_CUE
  float way = (1.0 / gl_FragCoord.w - frame.spread.w) / (2.0 * frame.center.w);
  result = mix(result, background(gl_FragCoord.y / frame.picture.y), frame.spread.z * clamp(way, 0.0, 1.0));
#endif
  color = vec4(result, 1.0);
}
