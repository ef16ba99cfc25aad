// Several kernels in one dispatch, for llvmpipe (gl/fused_pass.h). The work groups of the dispatch form a crew: they
// take the work groups of one kernel after another, some at a time, until none is left, and wait for each other before
// the next kernel. The assignment has no effect on results, because kernels do not depend on the order of their work
// groups.
//
// OpenGL does not guarantee that all groups of a dispatch run at the same time. So a group joins when it begins to run,
// and others wait for it only from then on; where groups run one after the other, the first does everything (compare
// the discovery of co-running groups of Sorensen, Donaldson, Batty, Gopalakrishnan, Rakamaric 2016). Also, llvmpipe
// ends all loops of an invocation after 65,535 iterations in total. So a group leaves the crew before that limit, and
// one that waited too long gives up: the next dispatch does the rest.
#define barrier()  // a work group is one vector, whose invocations run in lockstep
layout(local_size_x = GROUP_SIZE) in;
// [0] number of the current kernel, members of the crew, waiting members; from [FIRST_COUNTER] on counters of the work
// groups taken: for every stretch, and in it for every kernel.
layout(std430) coherent buffer Crew { uint crew[]; };
uniform usamplerBuffer plan;  // the list of work: gl/fused_source.h
uniform uint repeats;
#define PLAN(i) (texelFetch(plan, int(i)).x)
#define MEMBER 64u
#define KERNEL_OF(word) ((word) >> KERNEL_SHIFT)
#define NONE 0x7fffffffu

uint fused_invocation;     // replaces gl_GlobalInvocationID.x of an unfused kernel
uint kernel_number = 0u;   // current kernel of this group
uint kernel_count = 0u;
// Variables of the first invocation:
uint word = 0u;              // last value read from crew[0]
uint joined_at = NO_KERNEL;  // the first kernel that this group helps with
uint loops = 0u;             // upper bound of its loop iterations so far
bool leaves = false;
shared uint told;            // value that the first invocation passes to the others

bool helps() { return joined_at != NO_KERNEL && kernel_number >= joined_at; }

// Returns the current kernel.
uint join_crew() {
  if (gl_LocalInvocationID.x == 0u) {
    uint expected;
    bool done;
    do {
      expected = word;
      word = atomicCompSwap(crew[0], expected, KERNEL_OF(expected) == NO_KERNEL ? expected : expected + MEMBER);
      done = word == expected;
      ++loops;
    } while (!done);
    told = joined_at = KERNEL_OF(word);
  }
  return told;
}

// The work groups of a kernel are divided into stretches for two members each: one takes from the beginning, the other
// from the end, and they meet where their speeds lead. So a member does about the same part of every kernel and mostly
// reads its own output, since data from another core arrives slowly. A member without work left helps in the other
// stretches. Parts become ever smaller (guided self-scheduling, Polychronopoulos, Kuck 1987), so that all end at about
// the same time.
// A counter stores what was taken from the beginning and, times FROM_END, from the end of a stretch, in units of some
// work groups.
#define FROM_END 0x10000u
#define MOST_UNITS 8192u  // of a stretch: far below FROM_END, even if many members ask for more than is left
#define STRETCHES_LOG2 uint(findMSB(gl_NumWorkGroups.x - 1u | 1u))  // divisions would generate much code
bool from_end() { return (gl_WorkGroupID.x & 1u) != 0u; }
uint stretch, stretches_left, units_left;  // units: upper bound
uint group, end_of_part;                   // taken work groups

void begin_kernel() {
  stretch = gl_WorkGroupID.x / 2u;
  stretches_left = 1u << STRETCHES_LOG2;
  units_left = MOST_UNITS;
}

// Takes `count` units of the stretch; an invocation runs at most `cost` iterations in each. Returns the counter before
// that, or NONE if this group must not take more.
uint take_units(uint size, uint count, uint cost) {
  if (gl_LocalInvocationID.x == 0u) {
    told = NONE;
    uint more = count * cost + 1u;  // including the loop that takes
    if (loops + more > MOST_LOOPS) leaves = true;
    if (helps() && !leaves) {
      uint stride = (kernel_count + 15u) / 16u * 16u;  // stretches have separate cache lines
      uint counter = FIRST_COUNTER + stretch * stride + kernel_number, asked = from_end() ? count * FROM_END : count;
      told = atomicAdd(crew[counter], asked);
      bool some = told % FROM_END + told / FROM_END < size;
      if (!some) atomicAdd(crew[counter], -asked);  // otherwise many requests could reach FROM_END
      loops += some ? more : 2u;
    }
  }
  return told;
}

// Takes at most `most` of a kernel's work groups.
void take_part(uint groups, uint most, uint cost) {
  uint first = groups * stretch >> STRETCHES_LOG2, last = groups * (stretch + 1u) >> STRETCHES_LOG2;
  uint unit_log2 = uint(max(findMSB(last - first) - 12, 0)), size = (last - first + (1u << unit_log2) - 1u) >> unit_log2;
  uint share = gl_NumWorkGroups.x == 1u ? size : max(min(units_left, size) / 4u, size / 64u);
  uint count = clamp(share, 1u, max(1u, most >> unit_log2));
  uint before = take_units(size, count, cost << unit_log2);
  uint taken_first = before % FROM_END, taken_last = before / FROM_END, taken = taken_first + taken_last;
  if (before == NONE || taken >= size) {
    units_left = 0u;
    group = end_of_part = 0u;
  } else {
    uint part = min(count, size - taken), begin = from_end() ? size - taken_last - part : taken_first;
    units_left = size - taken - part;
    group = first + (begin << unit_log2);
    end_of_part = min(group + (part << unit_log2), last);
  }
  if (before == NONE) {
    stretches_left = 0u;
  } else if (units_left == 0u) {
    --stretches_left;
    stretch = (stretch + 1u) & ((1u << STRETCHES_LOG2) - 1u);
    units_left = size / 2u;  // other members have begun it
  }
}

// The work groups of kernel `next` of the generated text, with its record in the plan; 1 for `next` 0: there may be
// work.
uint groups_of(uint next, uint record);

// Skips the next kernel if it has no work: no member then needs to wait after it.
void wait_for_crew(uint next, uint record) {
  memoryBarrierBuffer();
  if (gl_LocalInvocationID.x == 0u) loops += LOOPS_OF_A_KERNEL;
  if (gl_LocalInvocationID.x == 0u && helps()) {
    uint expected, then;
    bool last, done;
    do {
      expected = word;
      uint members = expected / MEMBER % MEMBER, waiting = expected % MEMBER, left = members - (leaves ? 1u : 0u);
      last = waiting + 1u == members && (waiting > 0u || !leaves);  // a waiting member has found no work left
      then = kernel_number + (last && groups_of(next, record) == 0u ? 2u : 1u);
      then = (then == kernel_count ? NO_KERNEL : then) << KERNEL_SHIFT;
      word = atomicCompSwap(crew[0], expected, last ? then + left * MEMBER : leaves ? expected - MEMBER : expected + 1u);
      done = word == expected;
      ++loops;
    } while (!done);
    float pause = 1.0;
    do {
      expected = word;
      bool gives_up = !leaves && loops > MOST_LOOPS + uint(pause) && KERNEL_OF(expected) == kernel_number;
      word = atomicCompSwap(crew[0], expected, gives_up ? expected - MEMBER - 1u : expected);
      leaves = leaves || gives_up && word == expected;
      // Yields the core to its other hardware thread.
      pause = inversesqrt(1.0 + inversesqrt(1.0 + inversesqrt(1.0 + inversesqrt(1.0 + inversesqrt(1.0 + pause)))));
      ++loops;
      done = leaves || KERNEL_OF(word) != kernel_number;
    } while (!done);
    joined_at = leaves ? NO_KERNEL : KERNEL_OF(word);
  }
  memoryBarrierBuffer();
  ++kernel_number;
}
