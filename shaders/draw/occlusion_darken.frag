// Averages the ambient light of 4 x 4 pixels at about the same depth, and multiplies the picture by it.
#include "draw/occlusion_view.glsl"
layout(binding = 1) uniform sampler2D gathered;
layout(location = 0) out vec4 factor;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy), last = ivec2(frame.picture.xy) - 1;
  float here = texelFetch(depth, pixel, 0).x;
  if (here == kNothing) discard;
  float z = away(here), sum = 0.0, weight = 0.0;
  for (int i = 0; i < 16; ++i) {
    ivec2 at = clamp(pixel + ivec2(i & 3, i >> 2) - 2, ivec2(0), last);
    float share = max(1.0 - abs(away(texelFetch(depth, at, 0).x) - z) / (0.1 * occlusion.x), 0.0);
    sum += share * texelFetch(gathered, at, 0).x;
    weight += share;
  }
  factor = vec4(vec3(mix(1.0, sum / weight, occlusion.y)), 1.0);
}
