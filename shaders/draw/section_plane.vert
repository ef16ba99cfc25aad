// The section plane as a square around the scene that is larger than the view: a strip of four vertices.
#include "common/frame.glsl"
#include "draw/tissue.glsl"

void main() {
  const float reach = 100.0;  // scene radii
  vec3 normal = frame.section.xyz;
  vec3 u = normalize(cross(normal, abs(normal.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0)));
  vec3 middle = frame.center.xyz + normal * (frame.section.w - dot(normal, frame.center.xyz));
  vec2 corner = reach * frame.center.w * (2.0 * vec2(gl_VertexID & 1, gl_VertexID >> 1) - 1.0);
  hand_on(vec4(middle + corner.x * u + corner.y * cross(normal, u), 0.0), normal);
}
