// The uniform block of a substep.
#include "shared/types.h"
layout(std140) uniform Step { StepValues step_values; };
#define GRAVITY step_values.gravity.xyz
#define SUBSTEP step_values.gravity.w
#define MANUAL_SPECTRAL_RADIUS step_values.solver.x
