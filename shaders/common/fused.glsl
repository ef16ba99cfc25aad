// Several kernels in one dispatch, for llvmpipe (gl/fused_pass.h). The work groups are a crew: they take the work groups of one
// kernel after another, some at a time, until none is left, and wait for each other before the next kernel. Who takes what changes nothing:
// kernels do not depend on the order of their work groups.
//
// Nobody promises that all groups of a dispatch run at the same time. So a group joins when it begins to run, and only from then on is
// waited for; where one runs after the other, the first does it all (compare the discovery of co-running groups of Sorensen, Donaldson,
// Batty, Gopalakrishnan, Rakamaric 2016). And llvmpipe ends all loops of an invocation once it has gone through 65,535 iterations of them
// together. So a group leaves the crew before that, and one that waited too long gives up: what is not done then is left to the next
// dispatch.
#define barrier()  // a work group is one vector, whose invocations go in step
layout(local_size_x = GROUP_SIZE) in;
// [0] number of the kernel that runs, members of the crew, members that wait; from [FIRST_COUNTER] on counters of what was taken: of every
// stretch, and in it of every kernel.
layout(std430) coherent buffer Crew { uint crew[]; };
uniform usamplerBuffer plan;  // what there is to do: gl/fused_source.h
uniform uint repeats;
#define PLAN(i) (texelFetch(plan, int(i)).x)
#define MEMBER 64u
#define KERNEL_OF(word) ((word) >> KERNEL_SHIFT)
#define NONE 0x7fffffffu

uint fused_invocation;     // what gl_GlobalInvocationID.x is to a kernel by itself
uint kernel_number = 0u;   // that this group has come to
uint kernel_count = 0u;
// Of the first invocation:
uint word = 0u;              // crew[0] when it was last seen
uint joined_at = NO_KERNEL;  // the first kernel that this group helps with
uint loops = 0u;             // iterations that it may have gone through
bool leaves = false;
shared uint told;            // by the first invocation to the others

bool helps() { return joined_at != NO_KERNEL && kernel_number >= joined_at; }

// Returns the kernel that runs.
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

// The work groups of a kernel lie in stretches for two members each: one goes through it from its beginning, the other from its end, and
// where they meet depends on how fast they are. So everybody does about the same part of every kernel, and most of what it reads is what
// it wrote: what another core wrote takes long to come. Who finds nothing left helps in the other stretches. Parts become ever smaller
// (guided self-scheduling, Polychronopoulos, Kuck 1987), so that all end at about the same time.
// A counter tells what was taken from the beginning and, times FROM_END, from the end of a stretch, in units of some work groups.
#define FROM_END 0x10000u
#define MOST_UNITS 8192u  // of a stretch: far from FROM_END, however many ask for more than is left
#define STRETCHES_LOG2 uint(findMSB(gl_NumWorkGroups.x - 1u | 1u))  // divisions would make much code
bool from_end() { return (gl_WorkGroupID.x & 1u) != 0u; }
uint stretch, stretches_left, units_left;  // units: at most
uint group, end_of_part;                   // work groups that were taken

void begin_kernel() {
  stretch = gl_WorkGroupID.x / 2u;
  stretches_left = 1u << STRETCHES_LOG2;
  units_left = MOST_UNITS;
}

// Takes `count` units of the stretch, in each of which an invocation goes through `cost` iterations at most. Returns the counter before
// that, or NONE where this group takes no more.
uint take_units(uint size, uint count, uint cost) {
  if (gl_LocalInvocationID.x == 0u) {
    told = NONE;
    uint more = count * cost + 1u;  // and the loop that takes
    if (loops + more > MOST_LOOPS) leaves = true;
    if (helps() && !leaves) {
      uint stride = (kernel_count + 15u) / 16u * 16u;  // stretches have cache lines of their own
      uint counter = FIRST_COUNTER + stretch * stride + kernel_number, asked = from_end() ? count * FROM_END : count;
      told = atomicAdd(crew[counter], asked);
      bool some = told % FROM_END + told / FROM_END < size;
      if (!some) atomicAdd(crew[counter], -asked);  // in many dispatches it would come to FROM_END
      loops += some ? more : 2u;
    }
  }
  return told;
}

// Of a kernel's work groups, not more than `most`.
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
    units_left = size / 2u;  // others have begun it
  }
}

// Of the kernel that the generated text names so, with its record in the plan; 1 for 0: there may be something to do.
uint groups_of(uint next, uint record);

// Where nothing is to be done in the next kernel it is passed over: nobody needs to wait for each other after it.
void wait_for_crew(uint next, uint record) {
  memoryBarrierBuffer();
  if (gl_LocalInvocationID.x == 0u) loops += LOOPS_OF_A_KERNEL;
  if (gl_LocalInvocationID.x == 0u && helps()) {
    uint expected, then;
    bool last, done;
    do {
      expected = word;
      uint members = expected / MEMBER % MEMBER, waiting = expected % MEMBER, left = members - (leaves ? 1u : 0u);
      last = waiting + 1u == members && (waiting > 0u || !leaves);  // who waits has found nothing left to take
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
      // Leaves the core to the thread beside this one.
      pause = inversesqrt(1.0 + inversesqrt(1.0 + inversesqrt(1.0 + inversesqrt(1.0 + inversesqrt(1.0 + pause)))));
      ++loops;
      done = leaves || KERNEL_OF(word) != kernel_number;
    } while (!done);
    joined_at = leaves ? NO_KERNEL : KERNEL_OF(word);
  }
  memoryBarrierBuffer();
  ++kernel_number;
}
