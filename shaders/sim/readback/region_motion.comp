// The largest squares of the speed, since the run without `accumulate`, and of the displacement in every region.
#include "common/io.glsl"
COMPUTE_1D
INPUT_VEC4(Displacement, displacement)       // [vertex_count] u [m]
INPUT_VEC4(Velocity, velocity)               // [vertex_count] v [m/s]
INPUT_UINT(RegionBegin, region_begin)        // [region_count + 1]
INPUT_UINT(RegionVertices, region_vertices)  // [vertex_count] by region
INOUT(float, RegionMotion, region_motion)    // [2 * region_count] max |v|^2, max |u|^2
uniform uint accumulate;

void main() {
  ITEM_OR_RETURN(i)
  float speed = accumulate != 0u ? region_motion[2u * i] : 0.0, displaced = 0.0;
  uint end = FETCH1(region_begin, i + 1u);
  for (uint k = FETCH1(region_begin, i); k < end; ++k) {
    uint v = FETCH1(region_vertices, k);
    vec3 u = FETCH(displacement, v).xyz, w = FETCH(velocity, v).xyz;
    speed = max(speed, dot(w, w));
    displaced = max(displaced, dot(u, u));
  }
  region_motion[2u * i] = speed;
  region_motion[2u * i + 1u] = displaced;
}
