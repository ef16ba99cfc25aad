// stats.json: the amount of work of a run, its speed, and the quality of its last state.
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sim/accuracy/nodal_stress.h"
#include "sim/accuracy/time_extrapolation.h"
#include "sim/output/run_provenance.h"
#include "sim/simulation/simulation.h"

namespace fascia {

/// What the last state is off by, told apart by cause: relative errors, of the displacements and of the peak stress.
struct Errors {
  std::optional<double> solver;           // the larger one of solver_step and RunError::relative
  double solver_step = 0;                 // WorstStep::of_displacement()
  double solver_time = 0;                 // [s] WorstStep::time()
  int solver_steps = 0;                   // WorstStep::compared()
  std::optional<double> solver_over_run;  // RunError::over_run
  std::optional<TimeError> time;
  double mesh = 0;                      // RunError::relative, of what nothing holds the larger one of it and mesh_state
  double mesh_state = 0;                // MeshError
  std::optional<double> mesh_over_run;  // estimate_mesh_error_in_motion()
  PeakErrors peak_stress;
  double peak_recovered = 0, peak_of_tets = 0;  // [Pa] von Mises stress that 1 % of the volume exceeds
};

struct RunStats {
  std::string renderer;  // or "reference solver, double precision"
  Provenance provenance;
  long steps = 0;
  double wall_s = 0;
  std::vector<double> step_ms,
      solve_ms;         // [steps]; solve: without exports and other work between steps (docs/guide/command-line.md)
  double residual = 0;  // of the last step, relative
  std::optional<double> imbalance;        // of the forces in the last step of the GPU (Diagnostics::imbalance)
  std::vector<ToolLoad> tool_loads;       // of the last step, [tool of the model]
  std::vector<PairLoad> pair_loads;       // of the last step, of tissue on tissue
  long taken_back = 0;                    // steps whose result would have led tissue through tissue
  double pair_search_ms = 0;              // that the CPU looked for tissue that touches tissue, in all steps
  std::optional<PeakStress> recovered;    // of the last state; only on request
  std::optional<double> error;            // of the last step, as in StepError; only on request
  std::optional<Errors> errors;           // only on request
  std::uint64_t dispatches_per_step = 0;  // of a solved step
  std::size_t kernels = 0;                // variants compiled
  std::size_t gpu_bytes = 0;
  std::map<std::string, std::size_t> gpu_buffers;  // bytes by name
};

/// Adds the GPU memory and work of the simulation in its current configuration.
void count_work(RunStats& stats, Simulation& simulation);

/// The summary of times, here and in the window: the median, so that a single delayed step does not count.
struct Percentiles {
  double median = 0, p95 = 0, max = 0;
};
Percentiles percentiles(std::vector<double> values);

void write_stats(const std::filesystem::path& path, const RunStats& stats, const Simulation& simulation,
                 const State& last);

}  // namespace fascia
