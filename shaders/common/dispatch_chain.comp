// A link of a chain of dispatches (app/bench/dispatch.h): adds one to every word of `chain`, which the link before it
// has stored, and reads as many inputs, of zeros, as it was made with.
// Reads chain, inputs. Writes chain.
#include "common/io.glsl"
COMPUTE_1D
INOUT(uint, Chain, chain)  // [invocations]
uniform uint items;        // words of an input
#if INPUTS >= 3
INPUT_UINT(Input0, input_0)
INPUT_UINT(Input1, input_1)
INPUT_UINT(Input2, input_2)
#endif
#if INPUTS >= 7
INPUT_UINT(Input3, input_3)
INPUT_UINT(Input4, input_4)
INPUT_UINT(Input5, input_5)
INPUT_UINT(Input6, input_6)
#endif
#if INPUTS >= 13
INPUT_UINT(Input7, input_7)
INPUT_UINT(Input8, input_8)
INPUT_UINT(Input9, input_9)
INPUT_UINT(Input10, input_10)
INPUT_UINT(Input11, input_11)
INPUT_UINT(Input12, input_12)
#endif

void main() {
  ITEM_OR_RETURN(i)
  uint sum = 1u;
#if INPUTS >= 3
  uint k = i % items;
  sum += FETCH1(input_0, k) + FETCH1(input_1, k) + FETCH1(input_2, k);
#endif
#if INPUTS >= 7
  sum += FETCH1(input_3, k) + FETCH1(input_4, k) + FETCH1(input_5, k) + FETCH1(input_6, k);
#endif
#if INPUTS >= 13
  sum += FETCH1(input_7, k) + FETCH1(input_8, k) + FETCH1(input_9, k);
  sum += FETCH1(input_10, k) + FETCH1(input_11, k) + FETCH1(input_12, k);
#endif
  chain[i] += sum;
}
