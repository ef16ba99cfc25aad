// Every tet separately: four flat faces, shrunk about the centroid, which is moved outward from the scene's center.
// With SECTION, tets whose centroid lies beyond the plane are omitted entirely.
#include "common/frame.glsl"
layout(binding = 1) uniform usamplerBuffer tet_vertices;
layout(binding = 2) uniform samplerBuffer positions;
#include "draw/tissue.glsl"

void main() {
  uvec4 v = texelFetch(tet_vertices, gl_VertexID / 12);
  vec4 p[4] = vec4[4](texelFetch(positions, int(v.x)), texelFetch(positions, int(v.y)), texelFetch(positions, int(v.z)),
                      texelFetch(positions, int(v.w)));
  vec3 middle = 0.25 * (p[0].xyz + p[1].xyz + p[2].xyz + p[3].xyz);
#if SECTION
  if (dot(frame.section.xyz, middle) > frame.section.w) {
    grab_on_nothing();
    return;
  }
#endif
  // The face opposite of vertex f, outward if the tet's volume is positive.
  int f = gl_VertexID % 12 / 3, k = gl_VertexID % 3;
  int a = (f + 1) & 3, b = (f + 2) & 3, c = (f + 3) & 3;
  if ((f & 1) == 1) {
    int other = b;
    b = c;
    c = other;
  }
  vec3 normal = cross(p[b].xyz - p[a].xyz, p[c].xyz - p[a].xyz);
  normal *= inversesqrt(max(dot(normal, normal), 1e-36));
  vec4 corner = p[k == 0 ? a : k == 1 ? b : c];
  corner.xyz = frame.spread.x * (corner.xyz - middle) + middle + frame.spread.y * (middle - frame.center.xyz);
  hand_on(corner, normal);
#if WIREFRAME
  barycentric = vec3(k == 0, k == 1, k == 2);
#endif
}
