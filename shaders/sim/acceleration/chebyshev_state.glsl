// What Chebyshev acceleration keeps between iterations, as floats in one buffer (sim/gpu/acceleration/chebyshev.cpp knows its size). The spectral
// radius stays from step to step.
#define CHEBYSHEV_WEIGHT 0          // omega of this iteration
#define CHEBYSHEV_RADIUS 1          // rho; 0: not known yet
#define CHEBYSHEV_COUNT 2           // accelerated iterations since the cycle began; negative: plain ones that are left
#define CHEBYSHEV_CYCLE_SQUARED 3   // |f|^2 when the cycle began
#define CHEBYSHEV_SQUARED 4         // |f|^2 of the iteration before
#define CHEBYSHEV_FIRST_SQUARED 5   // |f|^2 of the substep's first iteration
