// The backdrop of pixels without geometry; a backdrop of a single color is not changed.
#include "common/background.glsl"
in vec2 place;
layout(location = 0) out vec4 color;

void main() {
#if BACKDROP_WHITE || BACKDROP_BLACK
  color = vec4(background(place.y), 1.0);
#else
  color = vec4(background(place.y) + dither(gl_FragCoord.xy), 1.0);
#endif
}
