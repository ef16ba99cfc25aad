// Vertex block descent (Chen, Liu, Yang, Yuksel 2024): every vertex of one color minimizes the quadratic model of the
// step's objective in its own three coordinates. No two vertices of a color share a tet, so each uses the results of
// the colors before it.
#include "common/io.glsl"
#define AT_VERTEX(v) FETCH_IN_PLACE(neighbor, v).xyz
COMPUTE_1D
INPUT_VEC4_IN_PLACE(Neighbor, neighbor)  // [vertex_count] displacement u [m]
#include "sim/elasticity/vertex_block.glsl"
#include "sim/elasticity/symmetric_inverse.glsl"
#include "sim/energy/terms.glsl"
INPUT_VEC4(Predicted, predicted)         // [vertex_count] u~ [m]
INPUT_FLOAT(Mass, mass)                  // [vertex_count] [kg]
INPUT_UINT(ColorVertex, color_vertex)    // vertices sorted by color, without constrained ones
OUTPUT(vec4, Displacement, displacement)
uniform uint first_item;                 // first entry of this color

void main() {
  ITEM_OR_RETURN(i)
  uint v = FETCH1(color_vertex, first_item + i);
  VertexBlock block = add_tets(v);
#ifdef DEFERS
  if (block.guard) {
    defer(i);
    return;
  }
#endif
  vec3 u = AT_VERTEX(v);
  float m = FETCH1(mass, v), k = external_stiffness(v, SUBSTEP * SUBSTEP);
  vec3 g = block.gradient + m * (u - FETCH(predicted, v).xyz) + external_gradient(v, u, SUBSTEP * SUBSTEP).xyz;
  block.hessian.d += m + k;
  float scale = 1.0 / (block.hessian.d.x + block.hessian.d.y + block.hessian.d.z);
  Sym3 inverse = inverse_of(Sym3(scale * block.hessian.d, scale * block.hessian.s));
  displacement[v].xyz = u - scale * times(inverse, g);
}
