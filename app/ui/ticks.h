// Marks of an axis at round numbers.
#pragma once
#include <string>
#include <vector>

namespace fascia {

struct Ticks {
  std::vector<double> values;  // ascending, within the range but for the rounding of float32
  int digits = 3;              // that tell each from its neighbor
};

/// At multiples of 1, 2 or 5 times a power of ten, at most `most` intervals (2 or more). An end that is such a multiple
/// has a mark.
Ticks linear_ticks(double low, double high, int most);
/// At powers of ten, every so many that there are `most` at most; low > 0.
Ticks decade_ticks(double low, double high, int most);

}  // namespace fascia
