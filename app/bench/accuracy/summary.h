// What the measurements of one case come to: how much it takes to be within a tolerance, who is on the Pareto frontier,
// and which pairs are worth a line in a chart.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/bench/accuracy/results.h"

namespace fascia {

/// Which of the points (time, error) no other point beats, that is, is as good as in both and better in one; by
/// ascending time. Of equal points the first; points that are not finite are on no frontier.
std::vector<std::size_t> pareto_frontier(const std::vector<Eigen::Vector2d>& points);

struct FrontierPoint {
  std::size_t pair;  // in CaseAccuracy::pairs
  double ms, error;
};
/// Of all points of all pairs whose error is below 1.
std::vector<FrontierPoint> frontier_of(const CaseAccuracy& result);

/// The fewest iterations whose error is at most `tolerance`.
std::optional<AccuracyPoint> first_within(const PairAccuracy& pair, double tolerance);

/// Of each method the acceleration with the smallest geometric mean of its errors, and the poster's pair: indices of
/// pairs, ascending. One that is not finite somewhere loses to all that are.
std::vector<std::size_t> pairs_to_draw(const CaseAccuracy& result);

/// Markdown: a table of every measured case.
std::string summary_of(const AccuracyResults& results, const std::vector<std::string>& notes);

}  // namespace fascia
