// Curvature of the elastic energy along z_f and z_c: sums over the tets of h^2 times
//   V dF_i : d^2 Psi / dF^2 : dF_j,   with damping its viscous part.
// Only the three sums are needed, not the products of the Hessian with the directions. After two_level_correct.
#include "common/io.glsl"
#include "common/reduce.glsl"
#include "common/step.glsl"
#include "common/tet.glsl"
#include "sim/elasticity.glsl"
COMPUTE_1D
INPUT_VEC4(Displacement, displacement)        // [vertex_count] u [m]
INPUT_VEC4(FineDirection, fine_direction)     // [vertex_count] z_f [m]
#if SPLIT
INPUT_VEC4(CoarseDirection, coarse_direction)  // [vertex_count] z_c [m]
#endif
OUTPUT(vec4, CurvaturePartials, curvature_partials)  // x z_f H z_f, y z_f H z_c, z z_c H z_c
uniform uint tet_count;

void main() {
  LANE_OR_RETURN(i)
  vec4 sum = vec4(0.0);
  for (uint k = i; k < tet_count; k += invocations) {
    uint t = LISTED_ITEM(k);
    Tet tet = load_tet(t);
    mat3 h = displacement_gradient(tet, FETCH(displacement, tet.v.x).xyz, FETCH(displacement, tet.v.y).xyz,
                                   FETCH(displacement, tet.v.z).xyz, FETCH(displacement, tet.v.w).xyz);
    vec4 material = material_of(t);
    Tangent tangent = tangent_of(t, h, material);
    float scale = SUBSTEP * SUBSTEP * tet.volume;
    mat3 df = displacement_gradient(tet, FETCH(fine_direction, tet.v.x).xyz, FETCH(fine_direction, tet.v.y).xyz,
                                    FETCH(fine_direction, tet.v.z).xyz, FETCH(fine_direction, tet.v.w).xyz);
    sum.x += scale * curvature(tangent, h, material, df, df);
#if SPLIT
    mat3 dc = displacement_gradient(tet, FETCH(coarse_direction, tet.v.x).xyz, FETCH(coarse_direction, tet.v.y).xyz,
                                    FETCH(coarse_direction, tet.v.z).xyz, FETCH(coarse_direction, tet.v.w).xyz);
    sum.y += scale * curvature(tangent, h, material, df, dc);
    sum.z += scale * curvature(tangent, h, material, dc, dc);
#endif
  }
  STORE_PARTIAL(curvature_partials, i, sum)
}
