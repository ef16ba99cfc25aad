// The tets of one color, in place: no two of them share a free vertex, so each uses the results of the colors before
// it. Dispatched once per color, in the order of the colors.
#include "common/io.glsl"
#include "sim/xpbd/xpbd_block.glsl"
COMPUTE_1D
INPUT_VEC4_IN_PLACE(Corner, corner)       // [vertex_count + phantom_count] displacement: xyz u [m], w inverse mass
                                          // [1/kg]
OUTPUT(vec4, Displacement, displacement)
INPUT_VEC4_IN_PLACE(Lambda, lambda)       // [2 * tet_count] multiplier: xyz of xx, yy, zz then of yz, xz, xy
OUTPUT(vec4, Multiplier, multiplier)
uniform uint first_item;                 // first tet of this color: the tets are sorted by color

void main() {
  ITEM_OR_RETURN(i)
  uint t = first_item + i;
  Tet tet = load_tet(t);
  vec4 u0 = FETCH_IN_PLACE(corner, tet.v.x), u1 = FETCH_IN_PLACE(corner, tet.v.y), u2 = FETCH_IN_PLACE(corner, tet.v.z), u3 = FETCH_IN_PLACE(corner, tet.v.w);
#if FIRST_ITERATION
  vec3 lambda_d = vec3(0.0), lambda_s = vec3(0.0);
#else
  vec3 lambda_d = FETCH_IN_PLACE(lambda, 2u * t).xyz, lambda_s = FETCH_IN_PLACE(lambda, 2u * t + 1u).xyz;
#endif
  mat3 h = displacement_gradient(tet, u0.xyz, u1.xyz, u2.xyz, u3.xyz);
#ifdef DEFERS
  if (needs_guard(h, material_of(t))) {
    defer(i);
    return;
  }
#endif
  BlockStep s = solve_block(t, tet, h, deformation_of(h, material_of(t)), vec4(u0.w, u1.w, u2.w, u3.w), lambda_d, lambda_s,
                            Sym3(vec3(0.0), vec3(0.0)));
  STORE3(multiplier[2u * t], lambda_d + s.change_d)
  STORE3(multiplier[2u * t + 1u], lambda_s + s.change_s)
  // Constrained vertices may be shared within a color: they do not move, so they are not written.
  if (u0.w > 0.0) displacement[tet.v.x].xyz = u0.xyz + s.dx0;
  if (u1.w > 0.0) displacement[tet.v.y].xyz = u1.xyz + s.dx1;
  if (u2.w > 0.0) displacement[tet.v.z].xyz = u2.xyz + s.dx2;
  if (u3.w > 0.0) displacement[tet.v.w].xyz = u3.xyz + s.dx3;
}
