// How the residual falls within one substep, for the settings in use and for others that the user pins: each has a
// solver of its own that starts from the state of the simulation, so that all of them solve the same step. Exists while
// its panel is open.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "sim/simulation/simulation.h"

namespace fascia {

class Convergence {
 public:
  static constexpr std::size_t kMostLines = 6;  // the one of the settings in use included

  struct Line {
    std::string name;              // "mass_splitting + chebyshev"
    std::vector<float> residuals;  // before the first and after each iteration; empty: not measured yet
    bool diverged = false;         // a residual was not finite: the line ends there
  };
  /// The settings in use first, then the pinned ones in the order they were pinned.
  std::vector<Line> lines() const;

  /// Keeps the settings in use as a line of their own. Nothing when they are pinned already or kMostLines are there.
  void pin(const SolverSettings& settings);
  void unpin(std::size_t line);  // index in lines(), not 0
  bool can_pin(const SolverSettings& settings) const;

  /// Measures one of the lines, in turn, on the step that `simulation` makes next. Call before that step.
  void measure(Simulation& simulation, gl::ProgramCache& programs);
  /// Another scene: its model is gone. What was pinned stays pinned.
  void forget();

 private:
  struct Probe {
    SolverSettings settings;
    std::unique_ptr<GpuSolver> solver;
    Line line;
  };
  std::vector<Probe> probes_;
  std::size_t next_ = 0;
};

/// Method, acceleration and what tells one from another: "gauss_seidel + chebyshev, 8 colors".
std::string short_name(const SolverSettings& settings);

}  // namespace fascia
