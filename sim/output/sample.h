// Quantities that are followed over time: numbers about one state and the timing of its step, the same in the window's
// plots and in the CSV files of `fascia run --history`.
#pragma once
#include <Eigen/Core>
#include <filesystem>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "sim/output/run_provenance.h"
#include "sim/simulation/simulation.h"

namespace fascia {

struct Sample {
  // Not measured, or not defined at this time
  static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

  long step = 0;                                                        // steps so far
  double time = 0;                                                      // simulated [s]
  double kinetic = 0, elastic = 0, gravitational = 0;                   // [J]; gravitational: 0 at the rest positions
  double volume_ratio = 1;                                              // over the volume at rest
  double min_det_f = 1, max_strain = 0, max_von_mises = 0;              // [-], [-], [Pa]
  double max_recovered = kUnknown, p99_recovered = kUnknown;            // [Pa] PeakStress; measure_recovered()
  Eigen::Vector3d momentum{0, 0, 0}, reaction{0, 0, 0}, grab{0, 0, 0};  // [kg m/s], [N], [N]; forces on the body
  std::vector<reference::Support> supports;  // of scenes in which some are moved; the sum of their forces is `reaction`
  std::vector<ToolLoad> tools;               // of each tool of the model
  std::vector<PairLoad> pairs;               // of the bodies that touch
  Eigen::Vector3d probe{kUnknown, kUnknown, kUnknown};  // displacement of the tracked vertex [m]
  double residual = kUnknown, iterations = kUnknown;    // of the last step; iterations per substep
  double step_ms = kUnknown, frame_ms = kUnknown;       // of one step, of one frame

  double total() const { return kinetic + elastic + gravitational; }
};

struct Column {
  const char* name;  // with unit: "kinetic_J"
  double (*value)(const Sample&);
  bool on_request = false;  // files have it if a sample does
};
std::span<const Column> sample_columns();

Sample sample_of(const Diagnostics& diagnostics);
/// The current state, measured in double precision, for simulations with the reference solver. Without the values that
/// only the GPU measures: the forces of single grabs, inertia, rounding and mean strain.
Diagnostics diagnostics_by_reference(const Simulation& simulation);
/// The current state with each support; waits for the GPU. Before the first step, residual and iterations are unknown.
Sample sample_now(Simulation& simulation, std::uint32_t probe);
/// Adds the recovered stress of the current state (sim/accuracy/nodal_stress.h), which takes as long as some steps.
void measure_recovered(Sample& sample, const Simulation& simulation);

/// Writes notes as lines "# keyword: text", the column names, and a row per sample: the shortest digits that read back
/// to the same number, an empty cell for unknown values. All samples have the same supports and tools; there are
/// columns for all bodies that may touch. Throws Error.
void write_samples(const std::filesystem::path& path, std::span<const Sample> samples, const Model& model,
                   const Provenance& provenance, std::uint32_t probe);

/// The free vertex that is farthest from the supports: for a cantilever, one at its tip.
std::uint32_t tip_vertex(const Model& model);

}  // namespace fascia
