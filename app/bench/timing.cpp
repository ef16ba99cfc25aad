#include "app/bench/timing.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "gl/loader.h"

namespace fascia {

void warm_up(const std::function<void()>& work) {
  constexpr double kMilliseconds = 300;
  if (gl::device().software) return;
  for (double spent = 0; spent < kMilliseconds;) spent += milliseconds_of(work);
}

double milliseconds_of(const std::function<void()>& work) {
  gl::Finish();
  const auto start = std::chrono::steady_clock::now();
  work();
  gl::Finish();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

Spread spread_of(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    return values[static_cast<std::size_t>(std::lround(share * static_cast<double>(values.size() - 1)))];
  };
  return {at(0.5), at(0.1), at(0.9)};
}

std::vector<Spread> time_iterations(const std::vector<GpuSolver*>& solvers, const State& start, int repetitions) {
  std::vector<std::vector<double>> times(solvers.size());
  if (!solvers.empty()) warm_up([&] { solvers.front()->step(); });
  for (int turn = 0; turn <= repetitions; ++turn)
    for (std::size_t s = 0; s < solvers.size(); ++s) {
      solvers[s]->upload(start);
      const double ms = milliseconds_of([&] { solvers[s]->step(); });
      const SolverSettings& settings = solvers[s]->settings();
      if (turn > 0) times[s].push_back(ms / (settings.iterations * settings.substeps));
    }
  std::vector<Spread> spreads;
  for (std::vector<double>& values : times) spreads.push_back(spread_of(std::move(values)));
  return spreads;
}

}  // namespace fascia
