// Sums over the free vertices for the relative residual of the step. After gradient.
// Forces are measured in units of the mean mass, so that the squares of small bodies stay in the range of float32.
#include "common/io.glsl"
#include "common/reduce.glsl"
#include "common/step.glsl"
COMPUTE_1D
INPUT_VEC4(Gradient, gradient)          // [vertex_count] xyz g = M (u - u~) + h^2 dU/du [kg m]
INPUT_VEC4(Displacement, displacement)  // [vertex_count] u [m]
INPUT_VEC4(Predicted, predicted)        // [vertex_count] xyz u~ [m], w inverse mass, 0 where constrained
INPUT_VEC4(Velocity, velocity)          // [vertex_count] v_n [m/s]
INPUT_FLOAT(Mass, mass)                 // [vertex_count] row sums of M [kg]
#include "sim/energy/terms.glsl"
// Two arrays of `partials`: x |g|^2, y |M (u - u~)|^2, z |h^2 dU/du|^2 + |h^2 M gravity|^2, w |h^2 external forces|^2
// [m^2]; x |M v|^2 [m^2/s^2]
OUTPUT(vec4, ResidualPartials, residual_partials)
uniform uint vertex_count, partials;

void main() {
  ITEM_OR_RETURN(i)
  vec4 sum = vec4(0.0);
  float motion = 0.0;
  FOR_ITEMS_OF_LANE(v, i, invocations, vertex_count) {
    vec4 predicted_v = FETCH(predicted, v);
    if (!(predicted_v.w > 0.0)) continue;
    float m = FETCH1(mass, v) * INVERSE_MEAN_MASS;
    vec3 u = FETCH(displacement, v).xyz, g = FETCH(gradient, v).xyz * INVERSE_MEAN_MASS;
    vec3 inertia = m * (u - predicted_v.xyz), elastic = g - inertia, weight = SUBSTEP * SUBSTEP * m * GRAVITY;
    vec3 pull = external_gradient(v, u, SUBSTEP * SUBSTEP * INVERSE_MEAN_MASS).xyz, momentum = m * FETCH(velocity, v).xyz;
    sum += vec4(dot(g, g), dot(inertia, inertia), dot(elastic, elastic) + dot(weight, weight), dot(pull, pull));
    motion += dot(momentum, momentum);
  }
  STORE_PARTIAL(residual_partials, i, sum)
  STORE_PARTIAL(residual_partials, i + partials * PARTIAL_STRIDE, vec4(motion, 0.0, 0.0, 0.0))
}
