// Anderson acceleration, before the first sweep of a substep: stores its start z_0.
#include "common/io.glsl"
COMPUTE_1D
INPUT_VEC4(Value, value)        // [invocations]
OUTPUT(vec4, Iterate, iterate)  // [invocations] z_0

void main() {
  ITEM_OR_RETURN(i)
  iterate[i] = vec4(FETCH(value, i).xyz, 0.0);
}
