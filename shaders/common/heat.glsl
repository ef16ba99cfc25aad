// Color of the heat map, sRGB, t in [0, 1]: dark violet to pale yellow, lightness rising evenly. A polynomial
// fitted to a path of equal steps in OKLab; the same coefficients as heat_color() in render/heat_color.cpp.
vec3 heat_color(float t) {
  t = clamp(t, 0.0, 1.0);
  return ((((( vec3(-28.4079, 1.3701, 3.7153) * t + vec3(81.6521, -1.4323, 1.4386)) * t +
      vec3(-89.3260, -2.9572, -14.8614)) * t + vec3(46.3621, 4.9944, 13.8098)) * t +
      vec3(-9.5676, -2.7173, -4.9611)) * t + vec3(0.0435, 1.6120, 0.9536)) * t + vec3(0.1941, 0.0546, 0.4469);
}
