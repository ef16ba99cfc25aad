// The largest K of a quadratic tet, over mu, that the iterations of two_level see
// (sim/quadratic/quadratic_multiplier.comp).
#ifndef FASCIA_SHARED_RELAXED_BULK_H
#define FASCIA_SHARED_RELAXED_BULK_H
#define RELAXED_BULK 10.0f
#define UNKNOWN_MULTIPLIER 1e30f
#endif
