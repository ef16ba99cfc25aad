// h^2 times the force of every grab spring on the tissue, h^2 k (target - u), for methods that treat springs as part of
// the objective.
#include "common/io.glsl"
#include "common/step.glsl"
COMPUTE_1D
INPUT_UINT(GrabVertex, grab_vertex)      // [grab_count]
INPUT_VEC4(GrabTarget, grab_target)      // [grab_count] xyz displacement [m], w stiffness [N/m]
INPUT_VEC4(Displacement, displacement)   // [vertex_count] u [m]
OUTPUT(vec4, GrabMultiplier, grab_multiplier)

void main() {
  ITEM_OR_RETURN(i)
  vec4 target = FETCH(grab_target, i);
  vec3 stretch = target.xyz - FETCH(displacement, FETCH1(grab_vertex, i)).xyz;
  grab_multiplier[i] = vec4(SUBSTEP * SUBSTEP * target.w * stretch, 0.0);
}
