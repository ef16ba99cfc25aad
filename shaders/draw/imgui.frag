// A triangle of a panel: its color times the font atlas or another texture.
layout(binding = 0) uniform sampler2D image;
in vec2 at;
in vec4 tint;
layout(location = 0) out vec4 color;

void main() { color = tint * texture(image, at); }
