// The data that Chebyshev acceleration keeps between iterations, as floats in one buffer
// (sim/gpu/acceleration/chebyshev.cpp has its size). The spectral radius is kept from step to step.
#define CHEBYSHEV_WEIGHT 0          // omega of this iteration
#define CHEBYSHEV_RADIUS 1          // rho; 0: unknown
#define CHEBYSHEV_COUNT 2           // accelerated iterations since the cycle began; negative: remaining plain ones
#define CHEBYSHEV_CYCLE_SQUARED 3   // |f|^2 at the start of the cycle
#define CHEBYSHEV_SQUARED 4         // |f|^2 of the previous iteration
#define CHEBYSHEV_FIRST_SQUARED 5   // |f|^2 of the substep's first iteration
