// Paths of goldens, and the permitted distance of a picture or a state from them.
#pragma once
#include <filesystem>

namespace fascia {

struct GoldenFiles {
  std::filesystem::path picture, state;  // empty: not compared
};

/// The defaults are measured: docs/guide/regression.md.
struct GoldenLimits {
  double mean = 0.5 / 255;  // of absolute channel differences, 0 to 1
  double share = 0.001;     // of pixels with a channel off by more than kPixelBound
  // Largest distance of a vertex from its golden, in sizes of the scene (diagonal of its box at rest)
  double state = 1e-5;
  // Largest difference of a tool's force, over the largest golden one
  double contact = 1e-3;
};
inline constexpr double kPixelBound = 8.0 / 255;

}  // namespace fascia
