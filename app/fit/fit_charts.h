// The charts of a fit: measured against simulated curves, and the misfit around the minimum.
#pragma once
#include <string>
#include <vector>

#include "app/charts/chart.h"
#include "sim/fit/fit.h"

namespace fascia {

struct NamedChart {
  std::string name;  // of its file, "1_reaction"
  Chart chart;
};

/// One for every measured vector with more than one time.
std::vector<NamedChart> curve_charts(const Experiment& experiment, const Eigen::VectorXd& simulated);
/// One for every parameter with a profile.
std::vector<NamedChart> profile_charts(const FitResult& result, bool noise_known);

}  // namespace fascia
