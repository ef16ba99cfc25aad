// The light around the scene, from formulas: a pale floor, a sky, a bright band opposite of the key light, and a large
// soft lamp where the key light is.

// Diffuse light from everywhere but the key light, for a normal with these cosines to the key light, to up and to the
// eye. The part of the eye keeps shapes apart that no other light reaches.
vec3 ambient_light(float n_l, float n_up, float n_v) {
  float sky = 0.5 + 0.5 * n_up, behind = 0.5 - 0.5 * n_l;
  return mix(vec3(0.30, 0.27, 0.26), vec3(0.36, 0.40, 0.46), sky) +
         vec3(0.26, 0.25, 0.27) * (behind * behind * behind) + vec3(0.09, 0.08, 0.075) * n_v;
}

// What a smooth wet surface reflects from a direction with these cosines to up and to the key light.
vec3 reflected_light(float r_up, float r_l) {
#if DETAIL
  vec3 light = mix(vec3(0.16, 0.14, 0.13), vec3(0.64, 0.68, 0.72), smoothstep(-0.25, 0.35, r_up));
  light += vec3(0.28, 0.28, 0.29) * smoothstep(0.45, 0.8, -r_l);        // the band behind
  return light + vec3(2.4, 2.3, 2.2) * smoothstep(0.80, 0.965, r_l);  // the lamp
#else
  return mix(vec3(0.16, 0.14, 0.13), vec3(0.64, 0.68, 0.72), clamp(0.5 + 1.5 * r_up, 0.0, 1.0));
#endif
}
