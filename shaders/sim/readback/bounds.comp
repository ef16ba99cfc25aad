// The box around the vertices and their largest speed, as bits whose order is that of the floats: for the CPU, which looks
// whether tools are near.
#include "common/io.glsl"
COMPUTE_1D
INPUT_VEC4(RestPosition, rest_position)  // [vertex_count] X [m]
INPUT_VEC4(Displacement, displacement)   // [vertex_count] u [m]
INPUT_VEC4(Velocity, velocity)           // [vertex_count] v [m/s]
INOUT(uint, Bounds, bounds)              // [7] initially zero: largest x, y, z, then of -x, -y, -z, then of |v|^2
uniform uint vertex_count;

uint in_order(float x) {
  uint bits = floatBitsToUint(x);
  return (bits & 0x80000000u) != 0u ? ~bits : bits | 0x80000000u;
}

void main() {
  ITEM_OR_RETURN(i)
  vec3 most = vec3(-3e38), least = vec3(3e38);
  float speed2 = 0.0;
  FOR_ITEMS_OF_LANE(v, i, invocations, vertex_count) {
    vec3 x = FETCH(rest_position, v).xyz + FETCH(displacement, v).xyz, w = FETCH(velocity, v).xyz;
    most = max(most, x);
    least = min(least, x);
    speed2 = max(speed2, dot(w, w));
  }
  for (int k = 0; k < 3; ++k) {
    atomicMax(bounds[k], in_order(most[k]));
    atomicMax(bounds[3 + k], in_order(-least[k]));
  }
  atomicMax(bounds[6], in_order(speed2));
}
