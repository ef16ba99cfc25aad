#include "sim/simulation/recovered_map.h"

#include <chrono>

#include "sim/accuracy/mesh_error.h"

namespace fascia {

RecoveredMap::Estimate RecoveredMap::estimate(ColorBy color, const Model& model, const State& state,
                                              const std::stop_token& stop) {
  if (color == ColorBy::mesh_error) return {at_vertices(model, estimate_mesh_error(model, state, stop)), {}};
  const NodalStress stress = nodal_stress(model, state, stop);
  return {{stress.von_mises.begin(), stress.von_mises.end()}, peak_of(stress, model)};
}

bool RecoveredMap::update(const Simulation& simulation, ColorBy color) {
  Subject subject{color, simulation.steps_made() - simulation.steps_asleep(), simulation.model.materials};
  if (running_.valid() && running_color_ != color) forget();
  if (!running_.valid() && subject != subject_) {
    subject_ = std::move(subject);
    running_color_ = color;
    running_ =
        std::async(std::launch::async, [color, model = simulation.model, state = simulation.state(),
                                        stop = stop_.get_token()] { return estimate(color, model, state, stop); });
  }
  if (!running_.valid() || running_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return false;
  shown_ = running_.get();
  color_ = running_color_;
  return true;
}

void RecoveredMap::measure(const Simulation& simulation, ColorBy color) {
  forget();
  shown_ = estimate(color, simulation.model, simulation.state());
  color_ = color;
}

void RecoveredMap::forget() {
  stop_.request_stop();
  if (running_.valid()) running_.wait();
  running_ = {};
  stop_ = {};
  subject_.reset();
}

}  // namespace fascia
