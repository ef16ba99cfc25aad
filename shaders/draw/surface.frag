// Lights the surface: key light with a soft shadow that scatters below the surface, light from the surroundings, and a
// wet film that reflects both. A CAP, the cut of a section plane, is not a surface of the tissue: its color does not
// depend on the light.
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
#if WIREFRAME
in vec3 barycentric;
#endif
layout(location = 0) out vec4 color;
#include "draw/paint.glsl"
#include "draw/environment.glsl"
#include "draw/key_shadow.glsl"
#if DETAIL
#include "draw/tissue_detail.glsl"
#endif

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
  return frame.region_color[region_here() & 7u].rgb;
#elif CAP
  return mix(paint_color().rgb, vec3(1.0, 0.66, 0.55), 0.25);  // tissue is paler inside
#else
  vec4 tissue = paint_color();
#if BASE_COLOR
  tissue.rgb = mix(tissue.rgb, own_color.rgb, own_color.a * (1.0 - tissue.w));
#endif
  return gl_FrontFacing ? tissue.rgb : tissue.brg * 0.6;
#endif
}

#if CAP
vec3 shaded() {
#if HEAT_MAP
  return heat_color(heat);
#else
  return linear_to_srgb(0.92 * base_color());
#endif
}
#elif HEAT_MAP
// The color encodes a number: light only darkens it, and full light shows the color bar's own color.
vec3 shaded() {
  vec3 n = normalize(gl_FrontFacing ? surface_normal : -surface_normal);
  float n_l = dot(n, frame.light.xyz), sky = 0.5 + 0.5 * dot(n, frame.up.xyz);
  float key = max((n_l + 0.15) / 1.15, 0.0) * mix(1.0, key_visibility(n), clamp(4.0 * n_l + 0.5, 0.0, 1.0));
  float shade = min(0.30 + 0.22 * sky + 0.62 * key, 1.0);
  return heat_color(heat) * linear_to_srgb(vec3(shade)).x;
}
#else
vec3 shaded() {
  vec3 n = normalize(gl_FrontFacing ? surface_normal : -surface_normal), l = frame.light.xyz, v = to_eye;
  vec3 albedo = base_color();
  float wetness = paint_structure().w;
  float terminator = clamp(4.0 * dot(n, l) + 0.5, 0.0, 1.0);
  float visibility = terminator > 0.0 ? mix(1.0, key_visibility(n), terminator) : 1.0;
#if DETAIL
  v = normalize(v);
  Detail here = detail(n);
  n = here.normal;
  albedo *= here.color;
#if BASE_COLOR
  here.lines *= 1.0 - own_color.a * (1.0 - paint_color().w);  // colors of the surface have their own
#endif
  albedo = mix(albedo, paint_lines().rgb, 0.6 * here.lines);
  wetness *= here.film;
#endif
  float n_l = dot(n, l), n_up = dot(n, frame.up.xyz), n_v = max(dot(n, v), 0.0);
  vec3 wrap = paint_wrap();
  vec3 key = clamp((n_l + wrap) / (1.0 + wrap), 0.0, 1.0) * visibility;
  vec3 light = vec3(0.82, 0.785, 0.74) * key + ambient_light(n_l, n_up, n_v);
  // The film: Fresnel reflection (Schlick 1994, half of it at grazing angles, where a rough film reflects less) of the
  // surroundings and of the key light.
  float graze = 1.0 - n_v, graze2 = graze * graze, fresnel = 0.03 + 0.5 * graze2 * graze2 * graze;
  float r_up = 2.0 * n_v * n_up - dot(v, frame.up.xyz), r_l = 2.0 * n_v * n_l - dot(v, l);
  float n_h = max(dot(n, normalize(l + v)), 0.0);
  float gloss = n_h * n_h;
  gloss *= gloss;
  gloss *= gloss;
  gloss *= gloss;
  gloss *= gloss;
  float tight = gloss * gloss;
  tight *= tight;
  tight *= tight;
  vec3 film = fresnel * reflected_light(r_up, r_l) + vec3(0.06 * gloss + 0.55 * tight) * (visibility * max(n_l, 0.0));
  return display(albedo * light + wetness * film);
}
#endif

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
