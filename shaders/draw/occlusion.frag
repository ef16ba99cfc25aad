// The share of ambient light that reaches each pixel: the scalable ambient obscurance of McGuire, Mara, Luebke 2012,
// eq. 10, at full resolution. Taps lie on a spiral that is rotated by one of 16 angles per pixel; occlusion_darken
// averages over 4 x 4 pixels.
#include "draw/occlusion_view.glsl"
layout(location = 0) out vec4 light;

const int kTaps = 20;
const float kTurns = 7.0, kLongest = 0.2;  // turns of the spiral; its largest radius, in heights of the picture

// Direction along the surface, from the neighbor that is closer in depth, so that edges do not distort normals.
vec3 along(vec3 p, ivec2 pixel, ivec2 direction) {
  vec3 next = view_place(pixel + direction) - p, before = p - view_place(pixel - direction);
  return abs(next.z) < abs(before.z) ? next : before;
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  if (texelFetch(depth, pixel, 0).x == kNothing) {
    light = vec4(1.0);
    return;
  }
  vec3 p = view_place(pixel);
  vec3 n = normalize(cross(along(p, pixel, ivec2(0, 1)), along(p, pixel, ivec2(1, 0))));  // z points away from the
                                                                                          // scene, toward the camera
  float reach = occlusion.x, radius = min(reach / (frame.picture.w * p.z), kLongest * frame.picture.y);
  float start = 6.2831853 * float((pixel.x & 3) * 4 + (((pixel.y & 3) + 2 * (pixel.x & 1)) & 3)) / 16.0, sum = 0.0;
  for (int i = 0; i < kTaps; ++i) {
    float way = (float(i) + 0.5) / float(kTaps), angle = 6.2831853 * kTurns * way + start;
    vec3 v = (view_place(pixel + ivec2(round(radius * way * vec2(cos(angle), sin(angle))))) - p) / reach;
    float square = dot(v, v), near = max(1.0 - square, 0.0);
    sum += near * near * near * max(dot(v, n) - 0.06, 0.0) / (square + 0.12);
  }
  light = vec4(max(1.0 - 9.0 * sum / float(kTaps), 0.0));
}
