// The picture's backdrop in sRGB, by the height in the picture (0 bottom, 1 top). The ground fades into it; with a
// transparent backdrop, colors fade to white.
vec3 background(float height) {
#if BACKDROP_WHITE || BACKDROP_TRANSPARENT
  return vec3(1.0);
#elif BACKDROP_BLACK
  return vec3(0.0);
#else
  const vec3 low = vec3(0.70, 0.725, 0.755), middle = vec3(0.86, 0.875, 0.89),
             high = vec3(0.60, 0.655, 0.715);
  float t = height - 0.58;
  vec3 toward = t < 0.0 ? (low - middle) * 2.97 : (high - middle) * 5.67;
  return middle + toward * (t * t);
#endif
}

// Noise of one 8-bit step, which hides the bands of a slow gradient; fixed in the picture. Steps of the plastic
// number's inverse and its square spread the values of neighboring pixels evenly.
float dither(vec2 pixel) { return (fract(dot(pixel, vec2(0.7548777, 0.5698403))) - 0.5) / 255.0; }
