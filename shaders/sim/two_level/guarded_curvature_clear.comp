// Clears the results of subspace_curvature for the pairs of tets that elastic_force deferred.
#include "common/io.glsl"
COMPUTE_1D
OUTPUT(vec4, GuardedCurvature, guarded_curvature)  // [pairs and single tets]

void main() {
  ITEM_OR_RETURN(i)
  guarded_curvature[i] = vec4(0.0);
}
