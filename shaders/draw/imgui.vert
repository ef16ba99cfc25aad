// Panels: positions in ImGui's pixels, origin at the top left. Colors are display values and are not converted.
layout(location = 0) in vec2 position;
layout(location = 1) in vec2 texture_position;
layout(location = 2) in vec4 vertex_color;
uniform vec4 view;  // left, top, 2 / width, 2 / height
out vec2 at;
out vec4 tint;

void main() {
  at = texture_position;
  tint = vertex_color;
  vec2 place = (position - view.xy) * view.zw;
  gl_Position = vec4(place.x - 1.0, 1.0 - place.y, 0.0, 1.0);
}
