// The cut of a section plane through the tets: up to two triangles per tet, recomputed from the deformed positions in
// every frame. Six vertices per tet; tets that the plane misses yield triangles without area. Every cut edge is
// interpolated from its end beyond the plane, so that tets that share it agree to the bit and the cut has no cracks.
#include "common/frame.glsl"
layout(binding = 1) uniform usamplerBuffer tet_vertices;
layout(binding = 2) uniform samplerBuffer positions;
#include "draw/tissue.glsl"

void main() {
  uvec4 v = texelFetch(tet_vertices, gl_VertexID / 6);
  vec4 p[4] = vec4[4](texelFetch(positions, int(v.x)), texelFetch(positions, int(v.y)), texelFetch(positions, int(v.z)),
                      texelFetch(positions, int(v.w)));
  precise float d[4];
  int beyond = 0;
  for (int i = 0; i < 4; ++i) {
    d[i] = dot(frame.section.xyz, p[i].xyz) - frame.section.w;
    if (d[i] >= 0.0) beyond |= 1 << i;
  }
  int within = 15 - beyond, count = bitCount(beyond), k = gl_VertexID % 6;
  bool second = k >= 3;  // the second of the two triangles
  if (count == 0 || count == 4 || (second && count != 2)) {
    grab_on_nothing();
    return;
  }
  // The corners of the cut lie on edges: on all three of a separated vertex, or on the four between two pairs.
  int corner = k < 3 ? k : k == 3 ? 0 : k - 2;
  int a, b;
  if (count == 2) {
    a = corner < 2 ? findLSB(beyond) : findMSB(beyond);
    b = corner == 0 || corner == 3 ? findLSB(within) : findMSB(within);
  } else {
    int lone = findLSB(count == 1 ? beyond : within), other = (lone + 1 + corner) & 3;
    a = count == 1 ? lone : other;
    b = count == 1 ? other : lone;
  }
  precise vec4 cut = mix(p[a], p[b], d[a] / (d[a] - d[b]));
  hand_on(cut, frame.section.xyz);
#if WIREFRAME
  barycentric = vec3(k % 3 == 0, k % 3 == 1, k % 3 == 2);
  // The line between the two triangles of a quadrilateral is not an edge of the tet.
  const float far = 1e6;
  if (count == 2) barycentric += second ? vec3(0.0, 0.0, far) : vec3(0.0, far, 0.0);
#endif
}
