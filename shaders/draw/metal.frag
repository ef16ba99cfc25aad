// Brushed metal: it reflects the surroundings and the key light, and is hardly lit itself.
#include "common/frame.glsl"
#include "common/color.glsl"
in vec3 to_eye;
in vec3 surface_normal;
#if BASE_COLOR
in vec4 own_color;  // a tint and its share
#endif
layout(location = 0) out vec4 color;
#include "draw/environment.glsl"
#include "draw/key_shadow.glsl"

void main() {
  vec3 n = normalize(gl_FrontFacing ? surface_normal : -surface_normal), l = frame.light.xyz, v = normalize(to_eye);
  float n_l = dot(n, l), n_up = dot(n, frame.up.xyz), n_v = max(dot(n, v), 0.0);
  float visibility = mix(1.0, key_visibility(n), clamp(4.0 * n_l + 0.5, 0.0, 1.0));
  float r_up = 2.0 * n_v * n_up - dot(v, frame.up.xyz), r_l = 2.0 * n_v * n_l - dot(v, l);
  float n_h = max(dot(n, normalize(l + v)), 0.0), broad = n_h * n_h;
  broad *= broad;
  broad *= broad;
  broad *= broad;
  vec3 metal = vec3(0.62, 0.64, 0.67);
#if BASE_COLOR
  metal = mix(metal, own_color.rgb, own_color.a);
#endif
  vec3 light = vec3(0.82, 0.785, 0.74) * (max(n_l, 0.0) * visibility);
  float graze = 1.0 - n_v;
  vec3 mirror = mix(metal, vec3(1.0), graze * graze * graze) * reflected_light(r_up, r_l);
  color = vec4(display(0.30 * metal * (light + ambient_light(n_l, n_up, n_v)) + 0.75 * mirror +
                       0.5 * broad * visibility * max(n_l, 0.0)),
               1.0);
}
