// The GPU solver as a simulator of experiments: for meshes that are too large for the reference solver. With its
// settings of the scene, so that a fit finds the values with which that solver meets the measurement.
#pragma once
#include <stop_token>

#include "gl/program.h"
#include "sim/fit/simulated/simulator.h"

namespace fascia {

class GpuSimulator : public Simulator {
 public:
  /// `programs` of the current context, which must stay current.
  explicit GpuSimulator(gl::ProgramCache& programs, std::stop_token stop = {})
      : programs_(programs), stop_(std::move(stop)) {}
  /// Statics in contact are solved by the reference solver, as everywhere. Throws Error for a mesh that is too large
  /// for that.
  std::optional<Course> run(const Scene& scene, const Model& model, const Schedule& schedule) const override;
  std::size_t most_threads() const override { return 1; }  // the context is current in one
  /// Statics end at a residual of 1e-5, motions have float32.
  double difference_step() const override { return 1e-2; }

 private:
  gl::ProgramCache& programs_;
  std::stop_token stop_;
};

}  // namespace fascia
