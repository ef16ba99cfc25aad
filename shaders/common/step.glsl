// The uniform block of a stage of a substep (sim/integrators/stage.h).
#include "shared/types.h"
layout(std140) uniform Step { StepValues step_values; };
#define GRAVITY step_values.gravity.xyz
#define SUBSTEP step_values.gravity.w
#define MANUAL_SPECTRAL_RADIUS step_values.solver.x
#define ITERATIONS step_values.solver.y
#define TOLERANCE step_values.solver.z
#define INVERSE_MEAN_MASS step_values.solver.w
#define FARTHEST step_values.guard.x
#define STAGE_DURATION step_values.guard.y
#define EXTRAPOLATION step_values.guard.z
#define STAGE_SHARE step_values.guard.w
