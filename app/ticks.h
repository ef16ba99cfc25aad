// Marks of an axis at round numbers.
#pragma once
#include <string>
#include <vector>

namespace fascia {

struct Ticks {
  std::vector<double> values;  // ascending, within the range
  int digits = 3;              // that tell each from its neighbor
};

/// At 1, 2 or 5 times a power of ten, `most` at most (2 or more).
Ticks linear_ticks(double low, double high, int most);
/// At powers of ten, every so many that there are `most` at most; low > 0.
Ticks decade_ticks(double low, double high, int most);

}  // namespace fascia
