// The surface from the camera's view, or with DEPTH_ONLY from the light's. WIREFRAME reads each triangle's corners by
// number, so that every vertex has its corner index; otherwise vertices are shared attributes.
#include "common/frame.glsl"
#if WIREFRAME
layout(binding = 1) uniform usamplerBuffer indices;
layout(binding = 2) uniform samplerBuffer corner_position;
layout(binding = 3) uniform samplerBuffer corner_normal;
#if BASE_COLOR
layout(binding = 5) uniform samplerBuffer corner_color;
#endif
#if DETAIL
layout(binding = 6) uniform samplerBuffer corner_rest;
#endif
#else
layout(location = 0) in vec4 position;
#if !DEPTH_ONLY
layout(location = 1) in vec4 normal;
#if BASE_COLOR
layout(location = 2) in vec4 color;
#endif
#if DETAIL
layout(location = 3) in vec4 rest_position;
#endif
#endif
#endif
#include "draw/tissue.glsl"
#if BASE_COLOR
out vec4 own_color;
#endif

void main() {
#if WIREFRAME
  int corner = int(texelFetch(indices, gl_VertexID).x);
  vec4 position = texelFetch(corner_position, corner);
  vec4 normal = texelFetch(corner_normal, corner);
#if BASE_COLOR
  vec4 color = texelFetch(corner_color, corner);
#endif
#if DETAIL
  vec4 rest_position = texelFetch(corner_rest, corner);
#endif
  barycentric = vec3(gl_VertexID % 3 == 0, gl_VertexID % 3 == 1, gl_VertexID % 3 == 2);
#endif
#if DEPTH_ONLY
  hand_on(position, vec3(0.0));
#else
  hand_on(position, normal.xyz);
#if BASE_COLOR
  own_color = color;
#endif
#if DETAIL
  rest = rest_position.xyz;
#endif
#endif
#if SECTION
  gl_ClipDistance[0] = frame.section.w - dot(frame.section.xyz, position.xyz);
#endif
}
