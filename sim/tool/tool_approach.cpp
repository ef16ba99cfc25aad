#include "sim/tool/tool_approach.h"

#include <algorithm>

#include "sim/tool/followed_place.h"

namespace fascia {
namespace {

constexpr double kLongestPart = 0.5;          // of the finest part
constexpr double kShortestPart = 1.0 / 1024;  // of the time: a path may jump

}  // namespace

std::vector<double> approach_times(const std::vector<Tool>& tools, const std::vector<double>& finest, double begin,
                                   double end, double tissue_size,
                                   const std::function<ToolMotion(double from, double to)>& motion,
                                   const ToolDepth& depth) {
  std::vector<std::size_t> deep;
  const ToolMotion whole = motion(begin, end);
  for (std::size_t t = 0; t < tools.size(); ++t)
    if (depth(t, whole.to[t]) >= 1) deep.push_back(t);
  if (deep.empty() || begin == end) return {end};
  const auto is_far = [&](const ToolMotion& part) {
    return std::any_of(deep.begin(), deep.end(), [&](std::size_t t) {
      return way_between(tools[t], part.from[t], part.to[t], tissue_size) > kLongestPart * finest[t];
    });
  };
  std::vector<double> times;
  std::size_t clear = 0;
  for (double from = begin; from < end; from = times.back()) {
    double to = end;
    while (to - from > kShortestPart * (end - begin) && is_far(motion(from, to))) to = 0.5 * (from + to);
    times.push_back(to);
    const ToolMotion part = motion(from, to);
    if (std::all_of(deep.begin(), deep.end(), [&](std::size_t t) { return depth(t, part.to[t]) <= 0; }))
      clear = times.size() - 1;
  }
  times.erase(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(clear));
  return times;
}

}  // namespace fascia
