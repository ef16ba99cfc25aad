// Fills a buffer from its beginning by repeating four words.
#include "common/io.glsl"
COMPUTE_1D
OUTPUT(uint, Filled, filled)
uniform uint word_0, word_1, word_2, word_3;

void main() {
  ITEM_OR_RETURN(i)
  filled[4u * i] = word_0;
  filled[4u * i + 1u] = word_1;
  filled[4u * i + 2u] = word_2;
  filled[4u * i + 3u] = word_3;
}
