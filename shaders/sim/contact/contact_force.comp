// Force, energy and stiffness of contact at every listed point, summed over the pieces that are near, and of every pair.
// Before gradient.
#include "common/io.glsl"
COMPUTE_1D
#include "sim/contact/point.glsl"
INPUT_VEC4(ContactRest, contact_rest)  // [2 * points] point.glsl
#include "sim/contact/row.glsl"
#if PAIRS
#include "sim/contact/pair.glsl"
#endif
INPUT_VEC4(Displacement, displacement)     // [vertex_count] u [m]
INPUT_VEC4(ContactMemory, contact_memory)  // [rows]
INPUT_VEC4(ContactAnchor, contact_anchor)  // [rows]
INPUT_UINT(ContactNear, contact_near)      // [points]
OUTPUT(vec4, ContactForce, contact_force)  // [points] xyz on the tissue [N], w energy [J]
OUTPUT(vec4, ContactBlock, contact_block)  // [2 * points] xyz of xx, yy, zz then of yz, xz, xy [N/m]
// [points] of the row that presses most or is nearest to it: xyz n sqrt k, w (lambda - k d) / sqrt k [sqrt J]
OUTPUT(vec4, ContactPressing, contact_pressing)

vec4 pressing_of(Row r) {
  float root = sqrt(r.penalty);
  return vec4(root * r.normal, (r.before + r.penalty * r.depth) / root);
}

// A loop that tests its condition last: llvmpipe runs the body of others once more.
void main() {
  ITEM_OR_RETURN(i)
  uvec4 vertices = FETCH(contact_vertices, i);
  vec4 weights = FETCH(contact_weights, i), force = vec4(0.0);
  vec3 u = AT_POINT(displacement, vertices, weights);
  Sym3 block = Sym3(vec3(0.0), vec3(0.0));
  vec4 pressing = vec4(0.0, 0.0, 0.0, -3e38);
#if PAIRS
  if (i >= points) {
    Row r = row_of(i - points, u, FETCH(contact_memory, row_of_pair(i - points)));
    force = vec4(force_of(r), energy_of(r));
    pressing = pressing_of(r);
    add_stiffness(block, r, r.normal);
  } else
#endif
  {
    uint near = FETCH1(contact_near, i);  // not 0: the point is listed
    vec4 rest = FETCH(contact_rest, 2u * i);
    vec4 more = FETCH(contact_rest, 2u * i + 1u);
    do {
      uint piece = uint(findLSB(near)), row = first_row_of(piece) + i;
      Row r = row_at(piece, row, rest, more, u, FETCH(contact_memory, row), FETCH(contact_anchor, row));
      force += vec4(force_of(r), energy_of(r));
      vec4 of_row = pressing_of(r);
      if (of_row.w > pressing.w) pressing = of_row;
      add_stiffness(block, r, FETCH(contact_normal, row).xyz);
      near &= near - 1u;
    } while (near != 0u);
  }
  contact_force[i] = force;
  contact_pressing[i] = pressing;
  STORE3(contact_block[2u * i], block.d)
  STORE3(contact_block[2u * i + 1u], block.s)
}
