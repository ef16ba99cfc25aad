// Inverse of the blocks of block_inverse.comp with the stiffness of contact as the last forces had it, or the ones before
// where these were stiffer. A point that begins to press, or whose friction begins to hold, is many times stiffer than
// its tissue; one that lets go in an iteration often presses again in the next. With FIRST, after block_inverse.comp, of
// all vertices; else, before iterations, of those around points that may touch something, a list (DEFERRED). On software
// renderers contact_gather.comp does this.
#include "common/io.glsl"
COMPUTE_1D
#include "common/step.glsl"
#include "common/symmetric.glsl"
INPUT_VEC4(BlockFree, block_free)  // [2 * vertex_count]
#if FIRST
OUTPUT(vec4, BlockPressed, block_pressed)  // [2 * vertex_count] the stiffness of the last forces [kg]
#else
INOUT(vec4, BlockPressed, block_pressed)
#endif
#include "sim/energy/terms.glsl"
#include "sim/two_level/store_inverse.glsl"

void main() {
  ITEM_OR_RETURN(i)
  Sym3 pressed = Sym3(vec3(0.0), vec3(0.0));
  ADD_EXTERNAL_BLOCK(pressed, i, SUBSTEP * SUBSTEP)
#if !FIRST
  Sym3 before = Sym3(block_pressed[2u * i].xyz, block_pressed[2u * i + 1u].xyz);
#endif
  STORE3(block_pressed[2u * i], pressed.d)
  STORE3(block_pressed[2u * i + 1u], pressed.s)
#if !FIRST
  if (trace(before) > trace(pressed)) pressed = before;
#endif
  vec4 free = FETCH(block_free, 2u * i);
  store_inverse(i, Sym3(free.xyz + pressed.d, FETCH(block_free, 2u * i + 1u).xyz + pressed.s), free.w);
}
