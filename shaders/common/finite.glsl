// Tests the bits of a float: in GLSL the results of comparisons and isnan() for a NaN depend on the compiler.
bool is_finite(float x) { return (floatBitsToUint(x) & 0x7f800000u) != 0x7f800000u; }
