// The share of the key light that reaches the ground, for every point under the shadow map, in the shadow map's
// coordinates: small and smooth, so that the ground itself needs one lookup per pixel. The light has a size: the higher
// the body is above the ground, the wider the edge of its shadow. The first step is the mean height of the cover near
// the light's path, the second the covered share within the corresponding width.
layout(binding = 0) uniform sampler2D ground_cover;
in vec2 place;
layout(location = 0) out vec4 light;

const int kSearch = 8, kTaps = 20;
const float kWidest = 0.06, kNarrowest = 0.7 / GROUND_SIZE;  // radius of the blur, in sides of the map

vec2 disc(int i, int count) {
  return sqrt((float(i) + 0.5) / float(count)) * vec2(cos(2.39996 * float(i)), sin(2.39996 * float(i)));
}

void main() {
  vec2 near = vec2(0.0);
  for (int i = 0; i < kSearch; ++i) near += texture(ground_cover, place + kWidest * disc(i, kSearch)).xy;
  float radius = clamp(PENUMBRA * near.y / max(near.x, 1e-3), kNarrowest, kWidest);
  float covered = 0.0;
  for (int i = 0; i < kTaps; ++i) covered += texture(ground_cover, place + radius * disc(i, kTaps)).x;
  // Fades toward the map's border, so that geometry across the border gets a soft edge.
  vec2 inside = 0.5 - abs(place - 0.5);
  light = vec4(1.0 - covered / float(kTaps) * clamp(10.0 * min(inside.x, inside.y), 0.0, 1.0));
}
