// Curvature of the elastic energy along z_f and z_c: sums over the tets of h^2 times
//   V [ (1 + damping/h) dE_i : D : dE_j + dF_i S : dF_j ],   dE = sym(F^T dF).
// Only the three sums are needed, not the products of the Hessian with the directions. After two_level_correct.
#include "common/io.glsl"
#include "common/reduce.glsl"
#include "common/step.glsl"
#include "common/symmetric.glsl"
#include "common/tet.glsl"
#include "sim/feature_material.glsl"
#include "sim/feature_damping.glsl"
#include "sim/material/st_venant_kirchhoff.glsl"
COMPUTE_1D
INPUT_VEC4(Displacement, displacement)        // [vertex_count] u [m]
INPUT_VEC4(FineDirection, fine_direction)     // [vertex_count] z_f [m]
#if SPLIT
INPUT_VEC4(CoarseDirection, coarse_direction)  // [vertex_count] z_c [m]
#endif
OUTPUT(vec4, CurvaturePartials, curvature_partials)  // x z_f H z_f, y z_f H z_c, z z_c H z_c
uniform uint tet_count;

// tr(a S b^T).
float geometric(mat3 a, Sym3 s, mat3 b) {
  return s.d.x * dot(a[0], b[0]) + s.d.y * dot(a[1], b[1]) + s.d.z * dot(a[2], b[2]) +
         s.s.x * (dot(a[1], b[2]) + dot(a[2], b[1])) + s.s.y * (dot(a[0], b[2]) + dot(a[2], b[0])) +
         s.s.z * (dot(a[0], b[1]) + dot(a[1], b[0]));
}

void main() {
  ITEM_OR_RETURN(i)
  vec4 sum = vec4(0.0);
  for (uint t = i; t < tet_count; t += invocations) {
    Tet tet = load_tet(t);
    mat3 h = displacement_gradient(tet, FETCH(displacement, tet.v.x).xyz, FETCH(displacement, tet.v.y).xyz,
                                   FETCH(displacement, tet.v.z).xyz, FETCH(displacement, tet.v.w).xyz);
    mat3 f = mat3(1.0) + h;
    Sym3 e = green_strain(h);
    vec4 material = material_of(t);
    float damping = damping_over_h(material);
    Sym3 before = previous_strain_of(t);
    Sym3 s = second_piola_stress(Sym3(e.d + damping * (e.d - before.d), e.s + damping * (e.s - before.s)), material);
    float scale = SUBSTEP * SUBSTEP * tet.volume;
    mat3 df = displacement_gradient(tet, FETCH(fine_direction, tet.v.x).xyz, FETCH(fine_direction, tet.v.y).xyz,
                                    FETCH(fine_direction, tet.v.z).xyz, FETCH(fine_direction, tet.v.w).xyz);
    Sym3 ef = strain_change(f, df);
    Sym3 sf = second_piola_stress(ef, material);
    sum.x += scale * ((1.0 + damping) * contract(sf, ef) + geometric(df, s, df));
#if SPLIT
    mat3 dc = displacement_gradient(tet, FETCH(coarse_direction, tet.v.x).xyz, FETCH(coarse_direction, tet.v.y).xyz,
                                    FETCH(coarse_direction, tet.v.z).xyz, FETCH(coarse_direction, tet.v.w).xyz);
    Sym3 ec = strain_change(f, dc);
    sum.y += scale * ((1.0 + damping) * contract(sf, ec) + geometric(df, s, dc));
    sum.z += scale * ((1.0 + damping) * contract(second_piola_stress(ec, material), ec) + geometric(dc, s, dc));
#endif
  }
  STORE_PARTIAL(curvature_partials, i, sum)
}
