// The force, the energy and the stiffness of a row, a contact point at a piece of a tool, as sim/contact/contact_energy.h
// states them, without the curvature of the tool's surface.
#include "common/symmetric.glsl"
#include "sim/contact/piece.glsl"
INPUT_VEC4(ContactNormal, contact_normal)  // [rows] xyz n0, w offset of the plane that stands for the piece, or NO_PLANE

struct Row {
  float pressing, before, depth;           // N [N], lambda [N], -d [m]
  float penalty, sliding;                  // k, c [N/m]
  vec3 normal, across;                     // n, and q [N]
  float bound;                             // b [N]
};

// `rest`, `more`: of contact_rest; `memory`: xyz t in the axes of the piece, w the force of the stage before; `anchor`: the u
// with which the point would go where the piece goes, w k.
Row row_at(uint piece, uint row, vec4 rest, vec4 more, vec3 u, vec4 memory, vec4 anchor) {
  precise vec3 x = rest.xyz + u;
  precise vec3 lost = (rest.xyz - (x - (x - rest.xyz))) + (u - (x - rest.xyz)) + more.xyz;  // of the sum (Knuth 1969)
  PiecePose pose = pose_at_end(piece);
  vec4 n0 = FETCH(contact_normal, row), d = vec4(n0.xyz, dot(n0.xyz, x) - n0.w);
  if (n0.w == NO_PLANE) {
    d = distance_to(piece, to_local(pose, x));
    d.w += lost_distance(piece, d.xyz);
    d.xyz = pose.axes * d.xyz;
    lost -= lost_place(piece);
  }
  d.w += dot(d.xyz, lost);  // rounded places are off by more than what small stiff tissue lets in under its load
  Row r;
  r.before = memory.w;
  r.penalty = anchor.w;
  r.depth = half_thickness(piece) - d.w;
  r.pressing = max(0.0, r.before + r.penalty * r.depth);
  r.normal = d.xyz;
  r.bound = friction_of(piece) * memory.w;
  r.sliding = max(STICKING * r.penalty, r.bound / full_slip(piece));
  vec3 q = pose.axes * memory.xyz - r.sliding * (u - anchor.xyz);
  r.across = r.bound > 0.0 ? q - dot(q, n0.xyz) * n0.xyz : vec3(0.0);
  return r;
}

vec3 within(vec3 q, float bound) {
  float size = length(q);
  return size > bound ? q * (bound / size) : q;
}

vec3 force_of(Row r) { return r.pressing * r.normal + within(r.across, r.bound); }

float energy_of(Row r) {
  float q = length(r.across);
  return 0.5 * (r.pressing - r.before) * (r.pressing + r.before) / r.penalty +
         (q <= r.bound ? 0.5 * q * q : r.bound * (q - 0.5 * r.bound)) / r.sliding;
}

void add_outer(inout Sym3 sum, float weight, vec3 v) {
  sum.d += weight * v * v;
  sum.s += weight * v.yxx * v.zzy;
}

// `n0`: the normal that friction is across.
void add_stiffness(inout Sym3 sum, Row r, vec3 n0) {
  if (r.pressing > 0.0) add_outer(sum, r.penalty, r.normal);
  if (r.bound <= 0.0) return;
  float q = length(r.across), penalty = r.sliding * (q <= r.bound ? 1.0 : r.bound / q);
  sum.d += penalty;
  add_outer(sum, -penalty, n0);
  if (q > r.bound) add_outer(sum, -penalty / (q * q), r.across);
}
