#include "app/fit/fit_charts.h"

#include <algorithm>
#include <cmath>

#include "app/fit/fit_text.h"

namespace fascia {
namespace {

using Eigen::Vector2d;

Axis axis_of(const std::string& label, const std::vector<Series>& series, bool horizontal) {
  double low = 0, high = 0;
  bool any = false;
  for (const Series& s : series)
    for (const Vector2d& point : s.points) {
      const double value = point[horizontal ? 0 : 1];
      if (!std::isfinite(value)) continue;
      low = any ? std::min(low, value) : value;
      high = any ? std::max(high, value) : value;
      any = true;
    }
  constexpr double kLeast = 1e-6;  // of the values: less is no range that can be drawn
  const double least = std::max(kLeast * std::max(std::abs(low), std::abs(high)), 1e-300);
  const double margin = std::max(horizontal ? 0 : 0.05 * (high - low), high - low < least ? least : 0);
  return {label, false, Vector2d(low - margin, high + margin)};
}

std::string vector_of(const MeasuredCurve& curve) { return curve.name.substr(0, curve.name.size() - 2); }

}  // namespace

std::vector<NamedChart> curve_charts(const Experiment& experiment, const Eigen::VectorXd& simulated) {
  std::vector<NamedChart> charts;
  Eigen::Index row = 0;
  std::size_t file = 0;
  for (const Measurement& measurement : experiment.measurements()) {
    ++file;
    std::string last;
    for (const MeasuredCurve& curve : measurement.curves) {
      const Eigen::Index begin = row;
      row += static_cast<Eigen::Index>(curve.values.size());
      if (curve.times.size() < 2) continue;
      if (charts.empty() || last != vector_of(curve)) {
        last = vector_of(curve);
        charts.push_back({std::to_string(file) + "_" + last, {}});
        charts.back().chart.title = measurement.file.filename().string() + ": " + last;
        charts.back().chart.x.label = "time [s]";
        charts.back().chart.y.label = std::string(curve.dimension == Dimension::force ? "force [" : "displacement [") +
                                      si_unit(curve.dimension) + "]";
      }
      Chart& chart = charts.back().chart;
      const std::string component = curve.name.substr(curve.name.size() - 1);
      Series measured{component + " measured", {}, curve.measurand.axis, 0, false, true};
      Series fitted{component + " simulated", {}, curve.measurand.axis, 0, true, false};
      for (std::size_t i = 0; i < curve.values.size(); ++i) {
        measured.points.emplace_back(curve.times[i], curve.values[i]);
        fitted.points.emplace_back(curve.times[i], simulated[begin + static_cast<Eigen::Index>(i)]);
      }
      chart.series.push_back(std::move(measured));
      chart.series.push_back(std::move(fitted));
    }
    for (const MeasuredShape& shape : measurement.shapes) row += static_cast<Eigen::Index>(shape.value_count());
  }
  for (NamedChart& named : charts) {
    named.chart.x = axis_of(named.chart.x.label, named.chart.series, true);
    named.chart.y = axis_of(named.chart.y.label, named.chart.series, false);
  }
  return charts;
}

std::vector<NamedChart> profile_charts(const FitResult& result, bool noise_known) {
  std::vector<NamedChart> charts;
  for (const MisfitProfile& profile : result.profiles) {
    const std::string& key = result.estimates.parameters[profile.parameter].key;
    const std::string unit = unit_of(key);
    Series series{"", {}, 0, 0, true, true};
    for (std::size_t i = 0; i < profile.values.size(); ++i)
      series.points.emplace_back(profile.values[i], profile.misfits[i]);
    NamedChart& named = charts.emplace_back();
    named.name = "profile_" + std::to_string(profile.parameter + 1);
    named.chart.title =
        "Misfit along " + key + (profile.of_errors ? ", 3 standard errors" : ", a tenth at either side");
    named.chart.series = {std::move(series)};
    named.chart.x = axis_of(key + (unit.empty() ? "" : " [" + unit + "]"), named.chart.series, true);
    named.chart.y =
        axis_of(noise_known ? "residual / noise" : "residual [% of the largest value]", named.chart.series, false);
  }
  return charts;
}

}  // namespace fascia
