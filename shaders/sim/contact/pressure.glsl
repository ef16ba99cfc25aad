// Contact pressure at a vertex: the normal forces of its contact points at the end of the step, over its area at rest.
// After contact_finish.
INPUT_UINT(ContactBegin, contact_begin)      // [vertex_count + 1]
INPUT_UINT(ContactEnd, contact_end)          // [vertex_count]
INPUT_UINT(ContactEntries, contact_entries)  // 4 * point + corner
INPUT_VEC4(ContactWeights, contact_weights)  // [points]
INPUT_VEC4(ContactForce, contact_force)      // [points] w normal force [N]
INPUT_FLOAT(ContactArea, contact_area)       // [vertex_count] [m^2]

// [Pa]
float contact_pressure(uint v) {
  float force = 0.0;
  uint end = FETCH1(contact_end, v);
  for (uint k = FETCH1(contact_begin, v); k < end; ++k) {
    uint entry = FETCH1(contact_entries, k);
    force += FETCH(contact_weights, entry / 4u)[entry % 4u] * FETCH(contact_force, entry / 4u).w;
  }
  return force > 0.0 ? force / FETCH1(contact_area, v) : 0.0;
}
