// Contact pressure at a vertex: the normal forces of its contact points at the end of the step, over its area at rest.
// After contact_finish.
#include "sim/contact/entry.glsl"
INPUT_VEC4(ContactForce, contact_force)  // [points] w normal force [N]
INPUT_FLOAT(ContactArea, contact_area)   // [vertex_count] [m^2]
#define ADD_PRESSING(point, weight, first) force += (weight) * FETCH(contact_force, point).w;

// [Pa]
float contact_pressure(uint v) {
  float force = 0.0;
  FOR_POINTS_AROUND(v, ADD_PRESSING)
  return force > 0.0 ? force / FETCH1(contact_area, v) : 0.0;
}
