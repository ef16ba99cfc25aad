// Contact with tools, gathered at a vertex from the points around it (sim/contact/contact_force.comp). CONTACT 1:
// forces and energies, 2: stiffness.
INPUT_UINT(ContactBegin, contact_begin)      // [vertex_count + 1]
INPUT_UINT(ContactEnd, contact_end)          // [vertex_count]
INPUT_UINT(ContactEntries, contact_entries)  // 4 * point + corner
INPUT_VEC4(ContactWeights, contact_weights)  // [points]
#if CONTACT == 1
INPUT_VEC4(ContactForce, contact_force)  // [points] xyz on the tissue [N], w energy [J]

// The first corner carries the energy of a point.
vec4 contact_gradient(uint v, vec3 u, float scale) {
  vec4 sum = vec4(0.0);
  uint end = FETCH1(contact_end, v);
  for (uint k = FETCH1(contact_begin, v); k < end; ++k) {
    uint entry = FETCH1(contact_entries, k);
    vec4 force = FETCH(contact_force, entry / 4u);
    sum += vec4(-FETCH(contact_weights, entry / 4u)[entry % 4u] * force.xyz, entry % 4u == 0u ? 2.0 * force.w : 0.0);
  }
  return scale * sum;
}
#else
INPUT_VEC4(ContactBlock, contact_block)  // [2 * points] xyz of xx, yy, zz then of yz, xz, xy [N/m]

Sym3 contact_block_of(uint v, float scale) {
  Sym3 sum = Sym3(vec3(0.0), vec3(0.0));
  uint end = FETCH1(contact_end, v);
  for (uint k = FETCH1(contact_begin, v); k < end; ++k) {
    uint entry = FETCH1(contact_entries, k);
    float weight = FETCH(contact_weights, entry / 4u)[entry % 4u], factor = scale * weight * weight;
    sum.d += factor * FETCH(contact_block, 2u * (entry / 4u)).xyz;
    sum.s += factor * FETCH(contact_block, 2u * (entry / 4u) + 1u).xyz;
  }
  return sum;
}
#endif
