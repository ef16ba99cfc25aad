// A free parameter of a fit: a number of the scene, and the coordinates in which it is fitted.
//
//   natural    log of the value where it is positive, else the value: intervals are symmetric in it
//   inner      what the solver moves: the natural coordinate, or between bounds low and high its logit
//              x = log((n - low) / (high - n)), so that no step leaves the bounds
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "sim/scene/scene.h"

namespace fascia {

struct Parameter {
  std::string key;  // as for --set
  double start = 1;
  bool logarithmic = true;
  struct Range {
    double low, high;
  };
  std::optional<Range> bounds;  // of the value
  struct Prior {
    double mean, spread;  // of the value: mean and standard deviation
  };
  std::optional<Prior> prior;

  double natural(double value) const;
  double from_natural(double natural) const;
  double inner(double value) const;
  double value(double inner) const;
  /// d natural/d inner.
  double natural_rate(double inner) const;
  /// Distance from the prior's mean in its spreads, in the natural coordinate; 0 without a prior.
  double prior_distance(double inner) const;
  double prior_rate(double inner) const;  // d prior_distance/d inner
};

/// The parameters of these keys, from their values in the scene; ratios are bounded as scenes are. Throws Error
/// "--free KEY: ..." for a key that is no number of the scene or that is given twice.
std::vector<Parameter> parameters_of(const Scene& scene, const std::vector<std::string>& keys);

/// Sets what "KEY=LOW:HIGH" or "KEY=MEAN:SPREAD" says. Throws Error "OPTION KEY: ...".
void set_bounds(std::vector<Parameter>& parameters, const std::string& text);
void set_prior(std::vector<Parameter>& parameters, const std::string& text);

}  // namespace fascia
