// Measures the motion of the vertices: the largest squares of the displacement since an earlier state, of the speed and
// of the total displacement, as bits of floats, whose order is that of the floats as long as these are not negative;
// then MEASURED, by which a dispatch that did nothing is told from tissue at rest.
#include "common/io.glsl"
COMPUTE_1D
INPUT_VEC4(Displacement, displacement)                 // [vertex_count] u [m]
INPUT_VEC4(Velocity, velocity)                         // [vertex_count] v [m/s]
INPUT_VEC4(EarlierDisplacement, earlier_displacement)  // [vertex_count] [m]
INOUT(uint, Motion, motion)                            // [4] initially zero
uniform uint vertex_count;

void main() {
  ITEM_OR_RETURN(i)
  float way = 0.0, speed = 0.0, displaced = 0.0;
  FOR_ITEMS_OF_LANE(v, i, invocations, vertex_count) {
    vec3 u = FETCH(displacement, v).xyz, d = u - FETCH(earlier_displacement, v).xyz, w = FETCH(velocity, v).xyz;
    way = max(way, dot(d, d));
    speed = max(speed, dot(w, w));
    displaced = max(displaced, dot(u, u));
  }
  atomicMax(motion[0], floatBitsToUint(way));
  atomicMax(motion[1], floatBitsToUint(speed));
  atomicMax(motion[2], floatBitsToUint(displaced));
  motion[3] = MEASURED;
}
