// One step of the bent beam by every solver choice, traced, and the exact step: the data of figures 3 and 4.
#pragma once
#include <memory>
#include <vector>

#include "app/bench/bench.h"
#include "sim/gpu/solver.h"

namespace fascia {

struct PairTrace {
  SolverChoice pair;
  std::unique_ptr<GpuSolver> solver;
  std::vector<Diagnostics> trace;  // [iterations + 1], the first one is of the prediction
  double error = 0;                // of the last iteration, as BeamStep::error_after
};

class BeamStep {
 public:
  /// Solves the step exactly and traces all valid choices. `young_modulus` [Pa].
  BeamStep(Bench& bench, double young_modulus, int iterations);
  BeamStep(const BeamStep&) = delete;
  BeamStep& operator=(const BeamStep&) = delete;

  const State& start() const { return start_; }
  double exact_strain() const { return exact_strain_; }
  std::vector<PairTrace>& pairs() { return pairs_; }
  std::size_t plain() const;  // index of averaged Jacobi without acceleration

  /// RMS |x - x_exact| over RMS |x_exact - x~| of an untraced step: 0 is solved, 1 is as far away as the prediction x~.
  double error_after(PairTrace& pair, int iterations) const;

  std::vector<std::string> notes() const;  // for tables
  Table traces() const;                    // a row for every choice and iteration
  /// last_rms_strain, last_error, last_inverted_tets, finite
  void add_last(std::vector<Cell>& row, const PairTrace& pair) const;
  Chart chart(const std::string& title) const;  // strain against iterations, a series for every choice

 private:
  double error(const State& state) const;

  Scene scene_;
  Model model_;
  State start_, exact_;
  std::vector<Eigen::Vector3d> predicted_;  // [vertex_count] displacement of x~ [m]
  double exact_strain_ = 0;
  std::vector<PairTrace> pairs_;
};

}  // namespace fascia
