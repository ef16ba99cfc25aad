// The distance between the solver's steps and exact ones: at intervals the reference solver repeats the last stage of
// a substep from its start on another thread, while the frames continue. Beside it the errors of the mesh and of the
// time step, which no iteration makes smaller.
#pragma once
#include <future>
#include <optional>
#include <stop_token>
#include <vector>

#include "sim/accuracy/nodal_stress.h"
#include "sim/simulation/errors/time_error.h"
#include "sim/simulation/simulation.h"

namespace fascia {

/// Compares both shapes at the end of a stage, the last one of a substep.
struct StepError {
  double relative = 0;               // RMS |u - u_exact| over RMS |u_exact - u~|: 1: as far away as the prediction
  double of_displacement = 0;        // RMS |u - u_exact| over RMS |u_exact|
  double mesh = 0;                   // MeshError::displacement of the solver's shape
  std::optional<TimeError> time;     // what the next kFollowedSteps gather; if requested
  PeakErrors peak_stress;            // the same of the recovered stress that 1 % of the volume exceeds
  double largest = 0;                // [m]
  double rms = 0, displacement = 0;  // [m] RMS |u - u_exact|, RMS |u_exact|
  long step = 0;                     // GpuSolver::steps_solved() at the end of the substep
  bool converged = true;             // the reference solver; if false, the error is unreliable
  std::vector<float> distance;       // [vertex_count] |u - u_exact| [m]
};

class TrueError {
 public:
  static constexpr std::size_t kMostTets = reference::NewtonSolver::kMostTets;

  TrueError() = default;
  TrueError(const TrueError&) = delete;
  TrueError& operator=(const TrueError&) = delete;
  ~TrueError();  // stops the thread and waits for it

  /// Requests one measurement, of the next step, with the error in time: the reference solver continues from that step
  /// with the grabs as they are, kFollowedSteps steps of the length in use and as many as estimate_time_error() takes
  /// of shorter ones.
  void request() { requested_ = true; }
  static constexpr int kFollowedSteps = 6;
  bool requested() const { return requested_; }  // and not yet begun
  bool busy() const { return waiting_ || running_.valid(); }
  const std::optional<StepError>& result() const { return result_; }

  /// Call once per frame, after its steps: copies the last substep if a measurement is due, or with `continuously`
  /// whenever none is pending and the last result is of an older substep. True when there is a new result.
  bool update(Simulation& simulation, bool continuously);
  /// Waits for the error of the last substep; zero before the first step. For a solver that always solves everything.
  /// Throws Error for more than kMostTets.
  const StepError& measure(Simulation& simulation);
  /// The same of the solver alone, without the errors of mesh, time and stress, which take longer.
  StepError measure_solver(Simulation& simulation);
  void forget();  // the state has jumped: discards a pending measurement

 private:
  struct Problem {  // copies: model, settings and springs may change before the thread ends
    Model model;
    SolverSettings settings;
    std::vector<GrabSpring> springs;
    IntegratorStage stage;
    ToolMotion tools;
    double end_time;
    long step;
    std::optional<State> last = {};  // after the substep, where the error in time is requested
  };
  static StepError compare(const Problem& problem, const SolvedStep& step, std::stop_token stop);
  static StepError compare_solver(const Problem& problem, const SolvedStep& step, std::stop_token stop, State& exact);
  static TimeError error_in_time(const Problem& problem, const std::stop_token& stop);
  void begin(Simulation& simulation, bool with_time);

  bool requested_ = false;
  std::optional<Problem> waiting_;  // waits for its snapshot
  StepSnapshot snapshot_;
  std::stop_source stop_;
  std::future<StepError> running_;
  std::optional<StepError> result_;
};

}  // namespace fascia
