#include "app/bench/accuracy/accuracy.h"

#include <algorithm>
#include <cmath>

#include "app/bench/accuracy/charts.h"
#include "app/bench/accuracy/problem.h"
#include "app/bench/accuracy/results.h"
#include "app/bench/accuracy/summary.h"
#include "app/bench/timing.h"
#include "base/file.h"

namespace fascia {
namespace {

namespace fs = std::filesystem;

/// A solver choice on a case, and the solver for its measurements.
class Contender {
 public:
  Contender(const Bench& bench, const AccuracyProblem& problem, const AccuracyCase& measured, PairAccuracy& result)
      : problem_(&problem),
        measured_(&measured),
        result_(&result),
        solver_(std::make_unique<GpuSolver>(*bench.graphics.programs, problem.model(),
                                            settings_of(measured, result.pair, 1))) {}

  void measure_errors(const Bench& bench, const std::vector<int>& iterations) {
    for (const int count : iterations) {
      prepare(count);
      for (int step = 0; step < problem_->steps(); ++step) {
        bench.stop_if_interrupted();
        solver_->step();
      }
      AccuracyPoint point;
      point.iterations = count;
      point.error = problem_->error(solver_->download());
      result_->points.push_back(point);
      // For a single step, more iterations begin with these and diverge, too; many steps may well converge with more.
      if (std::isnan(point.error) && problem_->steps() == 1) return;
    }
  }

  /// Times the first step with the iterations of point `index`, if it exists and is finite.
  void time(std::size_t index) {
    if (index >= result_->points.size() || std::isnan(result_->points[index].error)) return;
    ms_.resize(result_->points.size());
    prepare(result_->points[index].iterations);
    ms_[index].push_back(milliseconds_of([&] { solver_->step(); }));
  }

  void finish() {
    for (std::size_t i = 0; i < ms_.size(); ++i) {
      if (ms_[i].empty()) continue;
      result_->points[i].ms_median = spread_of(ms_[i]).median;
      result_->points[i].ms_min = *std::min_element(ms_[i].begin(), ms_[i].end());
    }
  }

 private:
  // The same start for every measurement: state from earlier runs, such as that of an acceleration, is reset.
  void prepare(int iterations) {
    solver_->set_settings(settings_of(*measured_, result_->pair, iterations));
    solver_->finish_background();
    solver_->upload(problem_->start());
  }

  const AccuracyProblem* problem_;
  const AccuracyCase* measured_;
  PairAccuracy* result_;
  std::unique_ptr<GpuSolver> solver_;
  std::vector<std::vector<double>> ms_;  // [points][repetitions]
};

// The contenders take turns, and a turn covers all numbers of iterations, so that a disturbance affects all of them
// alike and few repetitions of each. The errors were measured before, so every kernel is compiled and has run.
void measure_times(const Bench& bench, std::vector<Contender>& contenders, std::size_t counts, int repetitions) {
  for (int turn = 0; turn < repetitions; ++turn)
    for (std::size_t i = 0; i < counts; ++i)
      for (Contender& contender : contenders) {
        bench.stop_if_interrupted();
        contender.time(i);
      }
  for (Contender& contender : contenders) contender.finish();
}

/// Measures the contenders that have no points yet, and returns their number.
int measure(Bench& bench, const AccuracyGrid& grid, CaseAccuracy& result) {
  const AccuracyProblem problem(bench, result.measured, grid.steps_of(result.measured));
  if (!problem.converged()) bench.say("the exact solution is less exact than it should be");
  const std::vector<int>& iterations = grid.iterations_of(result.measured);
  std::vector<Contender> contenders;
  for (PairAccuracy& pair : result.pairs) {
    if (!pair.points.empty()) continue;
    bench.stop_if_interrupted();
    contenders.emplace_back(bench, problem, result.measured, pair).measure_errors(bench, iterations);
  }
  measure_times(bench, contenders, iterations.size(), grid.repetitions);
  return static_cast<int>(contenders.size());
}

long missing_pairs(const CaseAccuracy& result) {
  return std::count_if(result.pairs.begin(), result.pairs.end(),
                       [](const PairAccuracy& p) { return p.points.empty(); });
}

}  // namespace

int bench_accuracy(Bench& bench, const AccuracyGrid& grid, bool fresh) {
  std::vector<std::string> notes = bench.notes();
  const std::vector<std::string> meaning = AccuracyProblem::notes(grid);
  notes.insert(notes.end(), meaning.begin(), meaning.end());
  const fs::path table = bench.folder / "accuracy.csv";
  AccuracyResults results = fs::exists(table) && !fresh ? read_results(table, grid, notes) : empty_results(grid);
  write_table(table, table_of(results, notes));  // a fresh run leaves no old numbers
  int measured = 0;
  for (std::size_t c = 0; c < results.size(); ++c) {
    const std::string name = "accuracy, case " + std::to_string(c + 1) + " of " + std::to_string(results.size()) +
                             ": " + title_of(results[c].measured) + ", ";
    if (const long missing = missing_pairs(results[c]); missing > 0) {
      bench.say(name + std::to_string(missing) + " pairs");
      measured += measure(bench, grid, results[c]);
      write_table(table, table_of(results, notes));
    } else {
      bench.say(name + "measured before");
    }
    write_file(bench.folder / "accuracy.md", summary_of(results, notes));
    draw_charts(bench, results[c]);
  }
  return measured;
}

}  // namespace fascia
