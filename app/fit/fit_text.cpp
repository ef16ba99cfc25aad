#include "app/fit/fit_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "base/text.h"
#include "sim/material/material.h"

namespace fascia {
namespace {

// Residuals are in units of the noise, which is assumed to be a hundredth of the largest value where it is not known.
constexpr double kAssumedPercent = 1;

std::string digits(double value) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.6g", value);
  return text.data();
}

}  // namespace

std::string unit_of(const std::string& key) {
  const std::string field = key.substr(key.rfind('.') + 1);
  std::string found;
  const Material usual;
  visit_material(usual, [&](double, const char* name, const char* unit, auto&&...) {
    if (field == name) found = unit;
  });
  return found;
}

std::string interval_text(const Estimate& estimate) {
  if (!estimate.determined) return "not determined";
  return std::isnan(estimate.low) ? "unknown" : digits(estimate.low) + " to " + digits(estimate.high);
}

std::string misfit_text(double misfit, bool noise_known) {
  return noise_known ? number(misfit) + " times the noise"
                     : number(kAssumedPercent * misfit) + " % of the largest values";
}

std::string effort_text(const FitResult& result) {
  std::string text = plural(static_cast<std::size_t>(result.simulations), "simulation");
  text += result.exact_rates ? " (rates by implicit differentiation)" : " (rates by differences)";
  if (result.profile_simulations > 0) text += ", " + std::to_string(result.profile_simulations) + " for the profile";
  return text;
}

std::string fit_text(const FitResult& result, bool noise_known) {
  std::size_t width = 0;
  for (const Estimate& estimate : result.estimates.parameters) width = std::max(width, estimate.key.size());
  std::string text;
  for (const Estimate& estimate : result.estimates.parameters) {
    const std::string unit = unit_of(estimate.key);
    text += estimate.key + std::string(width - estimate.key.size() + 2, ' ') + digits(estimate.value) +
            (unit.empty() ? "" : " " + unit) + "   95 %: " + interval_text(estimate) + '\n';
  }
  for (std::size_t a = 0; a < result.estimates.parameters.size(); ++a)
    for (std::size_t b = a + 1; b < result.estimates.parameters.size(); ++b)
      text += "correlation " +
              number(result.estimates.correlation(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b))) + ": " +
              result.estimates.parameters[a].key + ", " + result.estimates.parameters[b].key + '\n';
  text += "residual " + misfit_text(result.misfit, noise_known) + ", at the start " +
          misfit_text(result.start_misfit, noise_known) + "; " + effort_text(result) + '\n';
  for (const std::string& warning : result.estimates.warnings) text += "warning: " + warning + '\n';
  return text;
}

}  // namespace fascia
