// A panel's triangle: its color times the font atlas or another picture.
layout(binding = 0) uniform sampler2D image;
in vec2 at;
in vec4 tint;
layout(location = 0) out vec4 color;

void main() { color = tint * texture(image, at); }
