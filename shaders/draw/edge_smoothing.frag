// Smooths stairs at edges after Lottes 2009 (FXAA): a pixel at an edge gets a part of its neighbor across the edge, the
// more, the nearer the end of the stair is. Pixels without contrast to their neighbors stay as they are.
layout(binding = 0) uniform sampler2D picture;
in vec2 place;
layout(location = 0) out vec4 color;

const float kLeastContrast = 0.04, kLeastShare = 0.10;  // of brightness, and of the brightest neighbor's
const int kSteps = 12;                                  // along the edge, from pixel to pixel

float brightness(vec4 c) { return dot(c.rgb, vec3(0.30, 0.59, 0.11)); }
float brightness_at(vec2 at) { return brightness(textureLod(picture, at, 0.0)); }
float beside(int x, int y) {
  ivec2 last = textureSize(picture, 0) - 1;
  return brightness(texelFetch(picture, clamp(ivec2(gl_FragCoord.xy) + ivec2(x, y), ivec2(0), last), 0));
}

// The distance to the end of an edge of this brightness [pixels], and how much brighter it is there.
vec2 end_of_edge(vec2 start, vec2 along, float edge, float limit) {
  float distance = 0.0, off = 0.0;
  for (int k = 0; k < kSteps && abs(off) < limit; ++k) {
    distance += k < 5 ? 1.0 : 2.0;
    off = brightness_at(start + distance * along) - edge;
  }
  return vec2(distance, off);
}

void main() {
  color = texelFetch(picture, ivec2(gl_FragCoord.xy), 0);
  float middle = brightness(color), up = beside(0, 1), down = beside(0, -1), left = beside(-1, 0), right = beside(1, 0);
  float most = max(max(max(up, down), max(left, right)), middle),
        least = min(min(min(up, down), min(left, right)), middle), contrast = most - least;
  if (contrast < max(kLeastContrast, kLeastShare * most)) return;

  // The edge runs across the direction in which brightness bends more.
  float up_left = beside(-1, 1), up_right = beside(1, 1), down_left = beside(-1, -1), down_right = beside(1, -1);
  float bend_y = 2.0 * abs(up + down - 2.0 * middle) + abs(up_left + down_left - 2.0 * left) +
                 abs(up_right + down_right - 2.0 * right);
  float bend_x = 2.0 * abs(left + right - 2.0 * middle) + abs(up_left + up_right - 2.0 * up) +
                 abs(down_left + down_right - 2.0 * down);
  bool level = bend_y >= bend_x;
  vec2 pixel = 1.0 / vec2(textureSize(picture, 0));
  vec2 along = level ? vec2(pixel.x, 0.0) : vec2(0.0, pixel.y);
  vec2 across = level ? vec2(0.0, pixel.y) : vec2(pixel.x, 0.0);
  float before = level ? down : left, after = level ? up : right;
  if (abs(before - middle) > abs(after - middle)) {
    across = -across;
    after = before;
  }

  // Between both rows of pixels the edge has their mean brightness; where that changes, it ends.
  float edge = 0.5 * (middle + after), limit = 0.25 * abs(middle - after);
  vec2 start = place + 0.5 * across;
  vec2 one = end_of_edge(start, -along, edge, limit), other = end_of_edge(start, along, edge, limit);
  vec2 nearer = one.x <= other.x ? one : other;
  // At the nearer end the edge steps toward this pixel's row only if brightness changes away from this pixel's.
  bool toward = (nearer.y < 0.0) != (middle - edge < 0.0);
  float share = toward ? 0.5 - nearer.x / (one.x + other.x) : 0.0;
  // Single pixels that differ from all around them.
  float around = (2.0 * (up + down + left + right) + up_left + up_right + down_left + down_right) / 12.0;
  float lone = smoothstep(0.4, 1.0, abs(around - middle) / contrast);  // a level edge has a third
  color = textureLod(picture, place + max(share, 0.6 * lone) * across, 0.0);
}
