// Light is added up in linear RGB and encoded once, here: framebuffers are plain RGBA8, so multisample resolve and blending
// see display values, which is what keeps thin bright edges smooth.

vec3 linear_to_srgb(vec3 c) {
  return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, greaterThan(c, vec3(0.0031308)));
}

// Identity up to the knee, so that a color chosen for a display stays that color; above it highlights roll off toward 1.
vec3 tone(vec3 c) {
  const float knee = 0.65;
  vec3 over = max(c - knee, 0.0);
  return min(c, knee) + over / (1.0 + over / (1.0 - knee));
}

vec3 display(vec3 light) { return linear_to_srgb(tone(light)); }
