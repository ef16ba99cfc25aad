// Measures the residual within one substep, for the current settings and for others that the user pins: each has a
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
  static constexpr std::size_t kMostLines = 6;  // including the one of the current settings

  struct Line {
    std::string name;              // "mass_splitting + chebyshev"
    std::vector<float> residuals;  // before the first and after each iteration; empty: not measured yet
    bool diverged = false;         // a residual was not finite: the line ends there
  };
  /// The current settings first, then the pinned ones in the order of pinning.
  std::vector<Line> lines() const;

  /// Keeps the current settings as a line of their own. No effect if they are already pinned or there are kMostLines
  /// lines.
  void pin(const SolverSettings& settings);
  void unpin(std::size_t line);  // index in lines(), not 0
  bool can_pin(const SolverSettings& settings) const;

  /// Measures one of the lines, in turn, on the next step of `simulation`. Call before that step.
  void measure(Simulation& simulation, gl::ProgramCache& programs);
  /// Call when the scene changes: discards its model. Pinned settings are kept.
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

/// Method, acceleration and the distinguishing settings: "gauss_seidel + chebyshev, 8 colors".
std::string short_name(const SolverSettings& settings);

}  // namespace fascia
