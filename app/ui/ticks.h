// Ticks of an axis at round numbers.
#pragma once
#include <string>
#include <vector>

namespace fascia {

struct Ticks {
  std::vector<double> values;  // ascending, within the range up to rounding of float32
  int digits = 3;              // enough to distinguish neighbors
};

/// Multiples of 1, 2 or 5 times a power of ten, with at most `most` intervals (2 or more). An end that is such a
/// multiple has a tick.
Ticks linear_ticks(double low, double high, int most);
/// Powers of ten, with a spacing that gives at most `most` ticks; low > 0.
Ticks decade_ticks(double low, double high, int most);

}  // namespace fascia
