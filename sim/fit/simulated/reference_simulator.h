// The double-precision reference solver as a simulator of experiments.
#pragma once
#include <stop_token>
#include <thread>

#include "sim/fit/simulated/simulator.h"

namespace fascia {

class ReferenceSimulator : public Simulator {
 public:
  explicit ReferenceSimulator(std::stop_token stop = {}) : stop_(std::move(stop)) {}
  std::optional<Course> run(const Scene& scene, const Model& model, const Schedule& schedule) const override;
  std::size_t most_threads() const override { return std::thread::hardware_concurrency(); }
  double difference_step() const override { return 1e-3; }

 private:
  std::optional<Course> equilibria(const Scene& scene, const Model& model, const Schedule& schedule) const;
  std::optional<Course> motion(const Scene& scene, const Model& model, const Schedule& schedule) const;

  std::stop_token stop_;
};

}  // namespace fascia
