// Weight 1 / (h^2 V E) [1/(kg m^2)] of both vectors of a tet's multipliers in Anderson's inner product: their energy,
// while displacements are weighted by mass.
#include "common/io.glsl"
#include "common/step.glsl"
#include "common/symmetric.glsl"
#include "common/tet.glsl"
#include "sim/elasticity/feature_material.glsl"
COMPUTE_1D
OUTPUT(float, MultiplierWeight, multiplier_weight)  // [2 * tet_count]

void main() {
  ITEM_OR_RETURN(t)
  float weight = 1.0 / (SUBSTEP * SUBSTEP * load_tet(t).volume * material_of(t).x);
  multiplier_weight[2u * t] = weight;
  multiplier_weight[2u * t + 1u] = weight;
}
