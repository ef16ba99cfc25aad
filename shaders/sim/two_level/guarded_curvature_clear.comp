// Clears the results of subspace_curvature and quadratic_curvature for the tets that were deferred.
#include "common/io.glsl"
COMPUTE_1D
OUTPUT(vec4, GuardedCurvature, guarded_curvature)  // [pairs and single tets, or quadratic ones]

void main() {
  ITEM_OR_RETURN(i)
  guarded_curvature[i] = vec4(0.0);
}
