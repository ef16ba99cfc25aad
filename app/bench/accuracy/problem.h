// One case of `fascia bench accuracy`: the beam, its initial state, and its exact final state.
#pragma once
#include "app/bench/accuracy/grid.h"
#include "app/bench/bench.h"
#include "sim/reference/newton.h"

namespace fascia {

class AccuracyProblem {
 public:
  /// Solves it exactly, for `steps` steps. Throws Interrupted between steps.
  AccuracyProblem(const Bench& bench, const AccuracyCase& measured, int steps);
  AccuracyProblem(const AccuracyProblem&) = delete;
  AccuracyProblem& operator=(const AccuracyProblem&) = delete;

  const Model& model() const { return model_; }
  const State& start() const { return start_; }
  int steps() const { return steps_; }
  bool converged() const { return converged_; }  // the exact solution, to the reference solver's tolerance

  /// Relative error of a state after all steps: 0 is solved, 1 is as far away as the prediction (settled: as the shape
  /// at rest). NaN if the state is not finite.
  double error(const State& state) const;
  static std::vector<std::string> notes(const AccuracyGrid& grid);  // definitions for tables

 private:
  int steps_;
  Model model_;
  State start_, exact_;
  double scale_ = 1;  // squared distance that counts as an error of 1 [m^2]
  bool converged_ = true;
};

}  // namespace fascia
