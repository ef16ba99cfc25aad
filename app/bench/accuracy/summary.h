// A summary of the measurements of one case: the cost of reaching a tolerance, the Pareto frontier, and the solver
// choices to draw in a chart.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/bench/accuracy/results.h"

namespace fascia {

/// The points (time, error) that no other point dominates, that is, equals in both and beats in one; by ascending time.
/// Of equal points the first; points that are not finite are never included.
std::vector<std::size_t> pareto_frontier(const std::vector<Eigen::Vector2d>& points);

struct FrontierPoint {
  std::size_t pair;  // in CaseAccuracy::pairs
  double ms, error;
};
/// The frontier of all points of all choices whose error is below 1.
std::vector<FrontierPoint> frontier_of(const CaseAccuracy& result);

/// The fewest iterations whose error is at most `tolerance`.
std::optional<AccuracyPoint> first_within(const PairAccuracy& pair, double tolerance);

/// For each method the acceleration with the smallest geometric mean of its errors, and the choice of the I3D 2019
/// paper: ascending indices into CaseAccuracy::pairs. A choice with a value that is not finite ranks below all others.
std::vector<std::size_t> pairs_to_draw(const CaseAccuracy& result);

/// Markdown: a table of every measured case.
std::string summary_of(const AccuracyResults& results, const std::vector<std::string>& notes);

}  // namespace fascia
