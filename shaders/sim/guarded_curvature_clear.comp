// Forgets what subspace_curvature left for the tets that elastic_force deferred.
#include "common/io.glsl"
COMPUTE_1D
OUTPUT(vec4, GuardedCurvature, guarded_curvature)  // [tet_count]

void main() {
  ITEM_OR_RETURN(t)
  guarded_curvature[t] = vec4(0.0);
}
