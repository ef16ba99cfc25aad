// The work group of a dispatch that arrives last goes on with what all groups have stored, in blocks declared COHERENT: no
// second dispatch has to wait for the first one. No group waits for another, so nothing is assumed about the order in
// which groups run. For GPUs, where a dispatch that depends on the one before costs microseconds.
COHERENT(uint, Arrivals, arrivals)  // [1] 0 before and after every dispatch
shared uint arrived_before;

// Called by all invocations of all groups, after their stores. True in the last group, to which the stores of all groups
// are then visible.
bool is_last_group() {
  memoryBarrierBuffer();
  barrier();
  if (gl_LocalInvocationID.x == 0u) arrived_before = atomicAdd(arrivals[0], 1u);
  barrier();
  if (arrived_before + 1u < gl_NumWorkGroups.x) return false;
  if (gl_LocalInvocationID.x == 0u) arrivals[0] = 0u;
  memoryBarrierBuffer();
  return true;
}
