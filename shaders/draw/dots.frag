// A disc with a border, its edges one pixel soft.
in vec2 offset;
flat in float radius_in_pixels;
uniform vec4 fill, border;
layout(location = 0) out vec4 color;

void main() {
  float distance = radius_in_pixels - length(offset);
  float inside = clamp(distance + 0.5, 0.0, 1.0);
  vec4 paint = mix(border, fill, clamp(distance - 0.25 * radius_in_pixels + 0.5, 0.0, 1.0));
  color = vec4(paint.rgb, paint.a * inside);
}
