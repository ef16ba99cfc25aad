// The surface as seen by the light; only depth is kept.
#include "common/frame.glsl"
layout(location = 0) in vec4 position;

void main() { gl_Position = vec4(2.0 * to_shadow(position.xyz) - 1.0, 1.0); }
