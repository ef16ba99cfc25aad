#include "app/bench/accuracy/charts.h"

#include <cmath>

#include "app/bench/accuracy/summary.h"

namespace fascia {
namespace {

constexpr double kLargestError = 10;  // larger errors are not shown
constexpr int kFrontierColor = 6;     // after the colors of the methods

// Named as in the tables: the display labels are too long for three columns.
Series series_of(const PairAccuracy& pair) {
  Series series;
  series.name = name_of(pair.pair) + (std::isnan(pair.points.back().error) ? ", diverges" : "");
  series.color = static_cast<int>(pair.pair.method);
  series.dash = static_cast<int>(pair.pair.acceleration);
  series.marks = true;
  return series;
}

// From the smallest of all errors.
Eigen::Vector2d error_range(const CaseAccuracy& result) {
  double smallest = 0.1;
  for (const PairAccuracy& pair : result.pairs)
    for (const AccuracyPoint& point : pair.points)
      if (point.error > 0) smallest = std::fmin(smallest, point.error);
  return {0.7 * smallest, kLargestError};
}

}  // namespace

void draw_charts(const Bench& bench, const CaseAccuracy& result) {
  Chart iterations, time;
  iterations.title = time.title = title_of(result.measured);
  iterations.x = {"iterations of each substep", false, {}};
  time.x = {"time of the step [ms], " + gl::device().renderer, true, {}};
  iterations.y = time.y = {"relative error, RMS [-]", true, error_range(result)};
  Series frontier;
  frontier.name = "Pareto frontier of all choices";
  frontier.color = kFrontierColor;
  for (const FrontierPoint& point : frontier_of(result)) frontier.points.emplace_back(point.ms, point.error);
  time.series.push_back(std::move(frontier));  // first: below the others
  for (const std::size_t p : pairs_to_draw(result)) {
    const PairAccuracy& pair = result.pairs[p];
    if (pair.points.empty()) continue;
    iterations.series.push_back(series_of(pair));
    time.series.push_back(series_of(pair));
    for (const AccuracyPoint& point : pair.points) {
      iterations.series.back().points.emplace_back(point.iterations, point.error);
      time.series.back().points.emplace_back(point.ms_median, point.error);
    }
  }
  bench.draw(file_name_of(result.measured) + "_iterations", iterations);
  bench.draw(file_name_of(result.measured) + "_time", time);
}

}  // namespace fascia
