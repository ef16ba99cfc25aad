// Four words at the beginning of a buffer.
#include "common/io.glsl"
COMPUTE_1D
OUTPUT(uint, Filled, filled)
uniform uint word_0, word_1, word_2, word_3;

void main() {
  ITEM_OR_RETURN(i)
  filled[0] = word_0;
  filled[1] = word_1;
  filled[2] = word_2;
  filled[3] = word_3;
}
