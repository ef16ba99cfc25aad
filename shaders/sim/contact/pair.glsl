// Pairs of places of the tissue, as sim/contact/pair_energy.h states their energy. After row.glsl.
// [3 * pairs] normal, gap [m]; start [m], penalty [N/m]; friction, row, 0, 0
INPUT_VEC4(ContactPairs, contact_pairs)
uniform uint points;                     // pairs come after these

uint row_of_pair(uint pair) { return uint(FETCH(contact_pairs, 3u * pair + 2u).y); }
float friction_of_pair(uint pair) { return FETCH(contact_pairs, 3u * pair + 2u).x; }

// `u`: of one side less that of the other [m].
Row row_of(uint pair, vec3 u, vec4 memory) {
  vec4 front = FETCH(contact_pairs, 3u * pair), start = FETCH(contact_pairs, 3u * pair + 1u);
  vec3 way = u - start.xyz;
  float along = dot(front.xyz, way);
  Row r;
  r.before = memory.w;
  r.penalty = start.w;
  r.depth = -front.w - along;
  r.pressing = max(0.0, r.before + r.penalty * r.depth);
  r.normal = front.xyz;
  r.bound = friction_of_pair(pair) * memory.w;
  r.sliding = STICKING * r.penalty;
  vec3 q = memory.xyz - r.sliding * way;
  r.across = r.bound > 0.0 ? q - dot(q, front.xyz) * front.xyz : vec3(0.0);
  return r;
}
