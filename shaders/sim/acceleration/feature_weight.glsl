// Weight of a vector in Anderson's inner product. Neutral value: 1.
#if WEIGHTED
INPUT_FLOAT(Weight, weight)  // [invocations]
float weight_of(uint i) { return FETCH1(weight, i); }
#else
float weight_of(uint i) { return 1.0; }
#endif
