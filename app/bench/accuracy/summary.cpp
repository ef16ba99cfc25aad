#include "app/bench/accuracy/summary.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <sstream>

#include "app/bench/bench.h"
#include "app/ui/units.h"

namespace fascia {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr SolverChoice kPosterPair{Method::jacobi, Acceleration::anderson_positions};

struct Tolerance {
  const char* name;
  double error;
};
constexpr std::array kTolerances{Tolerance{"10 %", 0.1}, Tolerance{"1 %", 0.01}, Tolerance{"0.1 %", 0.001}};

double mean_log_error(const PairAccuracy& pair) {
  double sum = 0;
  for (const AccuracyPoint& point : pair.points) {
    if (std::isnan(point.error)) return kInfinity;
    sum += std::log(std::max(point.error, 1e-12));  // the double-precision reference is not exact either
  }
  return pair.points.empty() ? kInfinity : sum / static_cast<double>(pair.points.size());
}

bool is_measured(const CaseAccuracy& result) {
  return std::any_of(result.pairs.begin(), result.pairs.end(), [](const PairAccuracy& p) { return !p.points.empty(); });
}

void write_case(std::ostream& out, const CaseAccuracy& result) {
  std::map<std::size_t, double> smallest_on_frontier;  // index of the solver choice, error
  for (const FrontierPoint& point : frontier_of(result))
    smallest_on_frontier[point.pair] = point.error;  // errors decrease along the frontier
  out << "\n## " << title_of(result.measured) << "\n\n| method + acceleration |";
  for (const Tolerance& tolerance : kTolerances) out << " iterations to " << tolerance.name << " | ms |";
  out << " Pareto, down to |\n|---|";
  for (std::size_t i = 0; i < 2 * kTolerances.size() + 1; ++i) out << "--:|";
  out << '\n';
  for (std::size_t p = 0; p < result.pairs.size(); ++p) {
    const PairAccuracy& pair = result.pairs[p];
    if (pair.points.empty()) continue;
    out << "| " << name_of(pair.pair) << " |";
    for (const Tolerance& tolerance : kTolerances) {
      const std::optional<AccuracyPoint> point = first_within(pair, tolerance.error);
      out << ' ' << (point ? std::to_string(point->iterations) : "-") << " | "
          << (point ? engineering(point->ms_median, "") : "-") << " |";
    }
    const auto on_frontier = smallest_on_frontier.find(p);
    out << (on_frontier == smallest_on_frontier.end() ? " |\n"
                                                      : " " + engineering(on_frontier->second, "", 2) + " |\n");
  }
}

}  // namespace

std::vector<std::size_t> pareto_frontier(const std::vector<Eigen::Vector2d>& points) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i].allFinite()) order.push_back(i);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(points[a].x(), points[a].y()) < std::pair(points[b].x(), points[b].y());
  });
  std::vector<std::size_t> frontier;
  double best = kInfinity;
  for (const std::size_t i : order)
    if (points[i].y() < best) {
      best = points[i].y();
      frontier.push_back(i);
    }
  return frontier;
}

std::vector<FrontierPoint> frontier_of(const CaseAccuracy& result) {
  std::vector<FrontierPoint> all, frontier;
  std::vector<Eigen::Vector2d> points;
  for (std::size_t p = 0; p < result.pairs.size(); ++p)
    for (const AccuracyPoint& point : result.pairs[p].points) {
      if (!(point.error < 1)) continue;  // no better than zero iterations
      all.push_back({p, point.ms_median, point.error});
      points.emplace_back(point.ms_median, point.error);
    }
  for (const std::size_t i : pareto_frontier(points)) frontier.push_back(all[i]);
  return frontier;
}

std::optional<AccuracyPoint> first_within(const PairAccuracy& pair, double tolerance) {
  for (const AccuracyPoint& point : pair.points)
    if (point.error <= tolerance) return point;
  return std::nullopt;
}

std::vector<std::size_t> pairs_to_draw(const CaseAccuracy& result) {
  std::vector<std::size_t> best;  // one of each method
  for (std::size_t p = 0; p < result.pairs.size(); ++p) {
    const PairAccuracy& pair = result.pairs[p];
    const auto same = std::find_if(best.begin(), best.end(),
                                   [&](std::size_t b) { return result.pairs[b].pair.method == pair.pair.method; });
    if (same == best.end())
      best.push_back(p);
    else if (mean_log_error(pair) < mean_log_error(result.pairs[*same]))
      *same = p;
  }
  std::set<std::size_t> drawn(best.begin(), best.end());
  for (std::size_t p = 0; p < result.pairs.size(); ++p)
    if (result.pairs[p].pair == kPosterPair) drawn.insert(p);
  return {drawn.begin(), drawn.end()};
}

std::string summary_of(const AccuracyResults& results, const std::vector<std::string>& notes) {
  std::ostringstream out;
  out << "# Accuracy of every method and acceleration\n\n";
  for (const std::string& note : notes) out << "- " << note << '\n';
  out << "- iterations to a tolerance: the fewest measured whose error is at most that; ms: of the step with them; -: "
         "not reached\n"
      << "- Pareto, down to: the smallest error, below 1, at which no point of any pair beats this pair in both time "
         "and error\n";
  for (const CaseAccuracy& result : results)
    if (is_measured(result)) write_case(out, result);
  return out.str();
}

}  // namespace fascia
