// The backdrop where nothing was drawn.
#include "common/background.glsl"
in vec2 place;
layout(location = 0) out vec4 color;

void main() { color = vec4(background(place.y) + dither(gl_FragCoord.xy), 1.0); }
