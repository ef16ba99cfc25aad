// The surface as seen by the camera. WIREFRAME reads each triangle's corners by number, so that every vertex
// knows which corner it is; without it, vertices are attributes and shared.
#include "common/frame.glsl"
#if WIREFRAME
layout(binding = 1) uniform usamplerBuffer indices;
layout(binding = 2) uniform samplerBuffer corner_position;
layout(binding = 3) uniform samplerBuffer corner_normal;
out vec2 barycentric;
#else
layout(location = 0) in vec4 position;
layout(location = 1) in vec4 normal;
#endif
out vec3 to_eye;
out vec3 surface_normal;
#if HEAT_MAP
out float heat;
#endif
#if SHADOW
out vec3 shadow_position;
#endif

void main() {
#if WIREFRAME
  int corner = int(texelFetch(indices, gl_VertexID).x);
  vec4 position = texelFetch(corner_position, corner);
  vec4 normal = texelFetch(corner_normal, corner);
  int number = gl_VertexID % 3;
  barycentric = vec2(number == 0, number == 1);
#endif
  gl_Position = to_clip(position.xyz);
  to_eye = normalize(frame.eye.xyz - position.xyz);
  surface_normal = normal.xyz;
#if HEAT_MAP
  heat = (position.w - frame.heat_range.x) * frame.heat_range.y;
#endif
#if SHADOW
  // Looked up a little off the surface, more so where the light grazes it: that removes self-shadowing
  // without moving the shadow's foot.
  float slope = 1.0 - max(dot(normal.xyz, frame.light.xyz), 0.0);
  shadow_position = to_shadow(position.xyz + normal.xyz * frame.light.w * (1.0 + 2.5 * slope));
  shadow_position.z = min(shadow_position.z, 1.0);  // as far as the map reaches
#endif
}
