// Springs of zero rest length that pull grabbed vertices to their targets, as XPBD constraints of compliance 1 /
// stiffness:
//   (w + alpha~) dlambda = -(u - target) - alpha~ lambda,  u += w dlambda.   Force on the tissue: lambda / h^2.
// Both sides are multiplied by 1 / alpha~, since the stiffness of a spring may be zero.
// One vertex per spring, so no two invocations write to one vertex. After every iteration of the method.
#include "common/io.glsl"
#include "common/step.glsl"
COMPUTE_1D
INPUT_UINT(GrabVertex, grab_vertex)  // [grab_count]
INPUT_VEC4(GrabTarget, grab_target)  // [grab_count] xyz displacement [m], w stiffness [N/m]
INOUT(vec4, GrabMultiplier, grab_multiplier)
INPUT_VEC4(Predicted, predicted)  // [vertex_count] w inverse mass [1/kg]
INOUT(vec4, Displacement, displacement)

void main() {
  ITEM_OR_RETURN(i)
  uint v = FETCH1(grab_vertex, i);
  vec4 target = FETCH(grab_target, i);
  vec3 u = displacement[v].xyz;
  float inv_mass = FETCH(predicted, v).w;
  float stiffness = target.w * SUBSTEP * SUBSTEP;
#if FIRST_ITERATION
  vec3 lambda = vec3(0.0);
#else
  vec3 lambda = grab_multiplier[i].xyz;
#endif
  vec3 change = (stiffness * (target.xyz - u) - lambda) / (1.0 + stiffness * inv_mass);
  grab_multiplier[i] = vec4(lambda + change, 0.0);
  displacement[v].xyz = u + inv_mass * change;
}
