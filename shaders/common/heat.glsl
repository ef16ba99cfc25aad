// Color of the heat map in sRGB for t in [0, 1], a polynomial; scalars beyond the range have the color of its end.
vec3 heat_color(float t) {
  t = clamp(t, frame.heat_range.z, frame.heat_range.w);
  vec3 color = frame.color_map[6].rgb;
  for (int k = 5; k >= 0; --k) color = color * t + frame.color_map[k].rgb;
  return color;
}
