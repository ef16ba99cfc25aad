// Momentum, energies, support reaction and the residual g = M (u - u~) - h^2 f of the implicit step, after
// diagnose_tet. Each invocation processes its share of the vertices and keeps its own sums. Forces of the residual are
// in units of the mean mass, so that the squares of small bodies stay in the range of float32.
#include "common/io.glsl"
#include "common/step.glsl"
COMPUTE_1D
INPUT_VEC4(RestPosition, rest_position)  // [vertex_count] w inverse mass [1/kg]
INPUT_FLOAT(Mass, mass)                  // [vertex_count] row sums of M [kg], also of constrained vertices
#if QUADRATIC_TETS
INPUT_FLOAT(OwnMass, own_mass)  // [vertex_count] without what moves at centroids, which centroid_diagnose adds up [kg]
#define OWN_MASS(v, mass) FETCH1(own_mass, v)
#else
#define OWN_MASS(v, mass) mass
#endif
INPUT_VEC4(Displacement, displacement)   // [vertex_count] u [m]
INPUT_VEC4(Predicted, predicted)         // [vertex_count] u~ [m], w inverse mass in this step
INPUT_VEC4(Velocity, velocity)           // [vertex_count] [m/s]
INPUT_UINT(SlotBegin, slot_begin)        // [vertex_count + 1]
INPUT_VEC4(Correction, correction)       // [slots] h^2 times the force of each corner [kg m], of middles with the
                                         // inertia of what moves at centroids
OUTPUT(VertexPartial, VertexPartials, vertex_partials)  // [invocations]
uniform uint vertex_count;

void main() {
  ITEM_OR_RETURN(i)
  VertexPartial partial = VertexPartial(vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
  FOR_ITEMS_OF_LANE(v, i, invocations, vertex_count) {
    vec3 impulse = vec3(0.0);
    uint end = FETCH1(slot_begin, v + 1u);
    for (uint k = FETCH1(slot_begin, v); k < end; ++k) impulse += FETCH(correction, k).xyz;
    vec4 rest = FETCH(rest_position, v);
    float m = FETCH1(mass, v), own = OWN_MASS(v, m);
    vec3 u = FETCH(displacement, v).xyz, velocity_v = FETCH(velocity, v).xyz;
    vec3 p = m * velocity_v;
    partial.momentum += vec4(p, 0.5 * own * dot(velocity_v, velocity_v));
    partial.angular += vec4(own * cross(rest.xyz + u, velocity_v), -m * dot(GRAVITY, u));
    partial.reaction.w = max(partial.reaction.w, dot(velocity_v, velocity_v));
    bool rests = rest.w > 0.0 && FETCH(predicted, v).w == 0.0;  // constrained for this step
    if (rests) continue;
    if (rest.w > 0.0) {
      float unit = INVERSE_MEAN_MASS;
      vec3 lag = u - FETCH(predicted, v).xyz, inertia = unit * m * lag, momentum = unit * p;
      vec3 g = unit * (own * lag - impulse), elastic = inertia - g;
      vec3 weight = SUBSTEP * SUBSTEP * unit * m * GRAVITY;
      partial.residual +=
          vec4(dot(g, g), dot(inertia, inertia), dot(elastic, elastic) + dot(weight, weight), dot(momentum, momentum));
      partial.inertia += vec4(own / (SUBSTEP * SUBSTEP) * lag + own * GRAVITY,
                              (m / SUBSTEP * length(u) + length(p)) / SUBSTEP);
    } else {
      partial.reaction.xyz -= impulse / (SUBSTEP * SUBSTEP) + m * GRAVITY;
    }
  }
  vertex_partials[i] = partial;
}
