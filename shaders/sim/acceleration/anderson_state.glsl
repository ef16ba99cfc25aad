// The data that Anderson acceleration keeps between iterations, as floats in one buffer
// (sim/gpu/acceleration/anderson.cpp has its size).
#define ANDERSON_NEXT 0      // slot of the newest column
#define ANDERSON_COUNT 1     // columns in use, 0 to window
#define ANDERSON_SQUARED 2   // |f|^2 of the previous iteration
#define ANDERSON_WEIGHTS 3   // [window] theta by slot
#define ANDERSON_GRAM 13     // [window * window] dot products of the columns of dF
