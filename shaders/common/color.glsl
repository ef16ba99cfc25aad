// Light is added in linear RGB and encoded once, here. Framebuffers are plain RGBA8, so multisample resolve and
// blending use display values, which keeps thin bright edges smooth.

// The sRGB curve as a cubic in the square root, fitted: within 0.4 / 255 from 0.01 up, and a third of the cost of pow.
// Darker than 0.0004 is black.
vec3 linear_to_srgb(vec3 c) {
  vec3 s = sqrt(c);
  return max(((0.17390 * s - 0.46415) * s + 1.31874) * s - 0.02696, 0.0);
}

// Identity up to the knee, so that a color chosen for a display is unchanged; above it highlights roll off toward 1.
vec3 tone(vec3 c) {
  const float knee = 0.65;
  vec3 over = max(c - knee, 0.0);
  return min(c, knee) + over / (1.0 + over / (1.0 - knee));
}

vec3 display(vec3 light) { return linear_to_srgb(tone(light)); }
