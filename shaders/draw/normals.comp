// Smooth normals of the deformed surface. One invocation per corner: a vertex of the surface with the fan of triangles
// that share its normal (a vertex on a sharp edge has several corners). Reads the solver's positions; writes, in the
// order of corners, position and scalar, and the unit normal n ~ sum over the fan of (b - p) x (c - p), which weights
// by area. The sum runs in a fixed order, so the same positions give the same bits.
#include "common/io.glsl"
INPUT_VEC4(Position, position)
INPUT_UINT(CornerVertex, corner_vertex)
INPUT_UINT(FanBegin, fan_begin)
INPUT_UINT(Fan, fan)  // b, c per triangle
OUTPUT(vec4, CornerPosition, corner_position)
OUTPUT(vec4, CornerNormal, corner_normal)
COMPUTE_1D

void main() {
  ITEM_OR_RETURN(i)
  vec4 p = FETCH(position, FETCH1(corner_vertex, i));
  uint end = FETCH1(fan_begin, i + 1u);
  vec3 n = vec3(0.0);
  for (uint k = FETCH1(fan_begin, i); k < end; ++k) {
    vec3 b = FETCH(position, FETCH1(fan, 2u * k)).xyz - p.xyz;
    vec3 c = FETCH(position, FETCH1(fan, 2u * k + 1u)).xyz - p.xyz;
    n += cross(b, c);
  }
  corner_position[i] = p;
  corner_normal[i] = vec4(n * inversesqrt(max(dot(n, n), 1e-36)), 0.0);
}
