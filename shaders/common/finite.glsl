// By its bits: what comparisons and isnan() make of what is no number is the compiler's choice in GLSL.
bool is_finite(float x) { return (floatBitsToUint(x) & 0x7f800000u) != 0x7f800000u; }
