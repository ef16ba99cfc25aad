// Declarations of kernel inputs and outputs. Inputs go through FETCH so that one source works for real GPUs (storage
// blocks) and llvmpipe (buffer textures over the same memory, 8 to 12 times faster there, same bits).
// A buffer that a dispatch writes must not be an INPUT of that dispatch: declare it INOUT.
//
//   INPUT_VEC4(Displacement, displacement)   ->  vec4 u = FETCH(displacement, i);
//   INPUT_UINT(SlotBegin, slot_begin)        ->  uint b = FETCH1(slot_begin, i);
//   OUTPUT(vec4, Correction, correction)     ->  correction[i] = ...;
//   INOUT(vec4, Displacement, displacement)  ->  displacement[i] += ...;
//   COHERENT(vec4, Partials, partials)       ->  the same, also of other work groups of the dispatch: common/last_group.glsl
//   INPUT_VEC4_IN_PLACE(Corner, corner)      ->  vec4 u = FETCH_IN_PLACE(corner, i);
//                                                an input that is the dispatch's own output under another name, for
//                                                kernels in which no invocation reads the output of another, and each
//                                                reads before it writes
// The application binds by the second name; the block name is the same word in PascalCase.
// In a fused program (common/fused.glsl) the buffers of all kernels are declared before the first one.
#ifdef FUSED
#define INPUT_VEC4(Block, name)
#define INPUT_UVEC4(Block, name)
#define INPUT_FLOAT(Block, name)
#define INPUT_UINT(Block, name)
#define OUTPUT(type, Block, name)
#define INOUT(type, Block, name)
#elif READ_TEXELS
#define INPUT_VEC4(Block, name) uniform samplerBuffer name;
#define INPUT_UVEC4(Block, name) uniform usamplerBuffer name;
#define INPUT_FLOAT(Block, name) uniform samplerBuffer name;
#define INPUT_UINT(Block, name) uniform usamplerBuffer name;
#else
#define INPUT_VEC4(Block, name) layout(std430) readonly buffer Block { vec4 name[]; };
#define INPUT_UVEC4(Block, name) layout(std430) readonly buffer Block { uvec4 name[]; };
#define INPUT_FLOAT(Block, name) layout(std430) readonly buffer Block { float name[]; };
#define INPUT_UINT(Block, name) layout(std430) readonly buffer Block { uint name[]; };
#endif
#ifndef FUSED
#define OUTPUT(type, Block, name) layout(std430) writeonly buffer Block { type name[]; };
#define INOUT(type, Block, name) layout(std430) buffer Block { type name[]; };
#define COHERENT(type, Block, name) layout(std430) coherent buffer Block { type name[]; };
#endif
// No rule orders the fetch of a texel before a store to the same memory (TEXELS_IN_ORDER), but llvmpipe executes them
// in order.
#if READ_TEXELS && !TEXELS_IN_ORDER
#define INPUT_VEC4_IN_PLACE(Block, name) layout(std430) readonly buffer Block { vec4 name[]; };
#define FETCH_IN_PLACE(name, i) name[i]
#else
#define INPUT_VEC4_IN_PLACE(Block, name) INPUT_VEC4(Block, name)
#define FETCH_IN_PLACE(name, i) FETCH(name, i)
#endif
#if READ_TEXELS
#define FETCH(name, i) texelFetch(name, int(i))
#define FETCH1(name, i) (texelFetch(name, int(i)).x)
#else
#define FETCH(name, i) name[i]
#define FETCH1(name, i) name[i]
#endif

// A vec4 whose w is not read or is already 0. The cost on software renderers is proportional to the number of floats
// stored; GPUs write whole vectors faster.
#if READ_TEXELS
#define STORE3(element, value) element.xyz = value;
#else
#define STORE3(element, value) element = vec4(value, 0.0);
#endif

#ifndef GROUP_SIZE
#define GROUP_SIZE 64
#endif
#ifdef FUSED
#define COMPUTE_1D uint invocations;
#define INVOCATION fused_invocation
#else
#define COMPUTE_1D layout(local_size_x = GROUP_SIZE) in; uniform uint invocations;
#define INVOCATION gl_GlobalInvocationID.x
#endif
// With LISTED a kernel processes the items of a list: those that a step solves while the others rest.
#ifdef LISTED
INPUT_UINT(ItemList, item_list)  // [number of items]
#define LISTED_ITEM(k) FETCH1(item_list, k)
#else
#define LISTED_ITEM(k) (k)
#endif
// Branches save nothing where invocations run in lockstep, so work that few items need is deferred. With DEFERS a
// kernel puts such an item on a list and returns; the same kernel with DEFERRED, dispatched by the list's count,
// processes the list (sim/gpu/passes/deferred_tets.h).
#if defined(DEFERS) || defined(DEFERRED)
uniform uint deferred_list, deferred_begin;  // offset of the list's numbers, and of its items
#endif
#ifdef DEFERS
INOUT(uint, Deferred, deferred)  // from deferred_list on: work groups for the items, 1, 1, number of items
void defer(uint i) {
  uint k = atomicAdd(deferred[deferred_list + 3u], 1u);
  deferred[deferred_begin + k] = i;
  atomicMax(deferred[deferred_list], k / uint(GROUP_SIZE) + 1u);
}
#endif
#ifdef DEFERRED
INPUT_UINT(DeferredItems, deferred_items)  // the same
#define ITEM_OR_RETURN(i) \
  if (INVOCATION >= FETCH1(deferred_items, deferred_list + 3u)) return; uint i = FETCH1(deferred_items, deferred_begin + INVOCATION);
#else
#define ITEM_OR_RETURN(i) if (INVOCATION >= invocations) return; uint i = LISTED_ITEM(INVOCATION);
#endif
// For sums: lane i of `lanes`, a multiple of 8, processes its share of `count` items, LISTED_ITEM(k). On GPUs
// consecutive lanes process consecutive items. On software renderers, whose vectors hold eight invocations, each vector
// has a contiguous stretch, since neighboring items share their inputs.
#define LANE_OR_RETURN(i) uint i = INVOCATION; if (i >= invocations) return;
#if !SUMS_IN_GROUPS
#define FOR_ITEMS_OF_LANE(k, i, lanes, count)                                                                  \
  for (uint stretch = 8u * (((count) + (lanes) - 1u) / (lanes)), k = (i) / 8u * stretch + (i) % 8u,            \
            end_of_stretch = min(count, ((i) / 8u + 1u) * stretch);                                            \
       k < end_of_stretch; k += 8u)
#else
#define FOR_ITEMS_OF_LANE(k, i, lanes, count) for (uint k = i; k < (count); k += (lanes))
#endif
