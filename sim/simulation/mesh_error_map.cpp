#include "sim/simulation/mesh_error_map.h"

#include <chrono>

#include "sim/accuracy/mesh_error.h"

namespace fascia {

bool MeshErrorMap::update(const Simulation& simulation) {
  Subject subject{simulation.steps_made() - simulation.steps_asleep(), simulation.model.materials};
  if (!running_.valid() && subject != subject_) {
    subject_ = std::move(subject);
    running_ = std::async(std::launch::async,
                          [model = simulation.model, state = simulation.state(), stop = stop_.get_token()] {
                            return at_vertices(model, estimate_mesh_error(model, state, stop));
                          });
  }
  if (!running_.valid() || running_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return false;
  values_ = running_.get();
  return true;
}

void MeshErrorMap::measure(const Simulation& simulation) {
  forget();
  values_ = at_vertices(simulation.model, estimate_mesh_error(simulation.model, simulation.state()));
}

void MeshErrorMap::forget() {
  stop_.request_stop();
  if (running_.valid()) running_.wait();
  running_ = {};
  stop_ = {};
  subject_.reset();
}

}  // namespace fascia
