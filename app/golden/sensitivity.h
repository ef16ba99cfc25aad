// How much a run amplifies rounding: the tolerances of a golden of chaotic motion (buckling, many folds in contact).
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/golden/golden.h"

namespace fascia {

/// The effect of moving the vertices at rest by rounding, in the units of GoldenLimits.
struct Sensitivity {
  double mean = 0, share = 0, state = 0, contact = 0;
};
/// That move, in sizes of the scene: the rounding of a float32 coordinate.
inline constexpr double kNudge = 1e-7;
/// Drivers round in every operation, not once: goldens permit so many times the measured effect.
inline constexpr double kSensitivityMargin = 10;

/// Between outcomes of one scene; NaN where the nudged one is.
Sensitivity sensitivity_of(const Outcome& outcome, const Outcome& nudged);

/// The limits, each raised to the margin times the sensitivity unless it differs from the default: then someone chose
/// it.
GoldenLimits widened(GoldenLimits limits, const Sensitivity& sensitivity);

/// NAME.sensitivity.csv beside NAME.csv or, without a golden of the state, NAME.png.
std::filesystem::path sensitivity_beside(const GoldenFiles& goldens);
/// That of the goldens; all zeros without a file. Throws Error for another file.
Sensitivity read_sensitivity(const GoldenFiles& goldens);
/// Writes the file if it widens a default limit, else removes it, and describes a change in a line. Throws Error.
std::vector<std::string> update_sensitivity(const Sensitivity& sensitivity, const GoldenFiles& goldens);

}  // namespace fascia
