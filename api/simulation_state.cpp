// Reads, sets, saves and writes the state of a simulation.
#include "api/simulation.h"
#include "api/values.h"
#include "sim/output/run_provenance.h"
#include "sim/output/simulation_fields.h"
#include "sim/output/state_export.h"

namespace fascia::api {

struct State::Carried {
  fascia::State::Earlier earlier;
  ContactMemory contact;
};

namespace {

template <class T>
void copy(const std::vector<Eigen::Vector3d>& from, std::span<T> to, const char* where) {
  if (to.size() != 3 * from.size())
    throw Error(where, "has room for " + std::to_string(to.size()) + " numbers",
                "expected " + std::to_string(3 * from.size()));
  for (std::size_t v = 0; v < from.size(); ++v)
    for (int k = 0; k < 3; ++k) to[3 * v + static_cast<std::size_t>(k)] = static_cast<T>(from[v][k]);
}

std::vector<Eigen::Vector3d> positions_of(const fascia::Simulation& simulation) {
  std::vector<Eigen::Vector3d> x = simulation.state().displacement;
  for (std::size_t v = 0; v < x.size(); ++v) x[v] += simulation.model.rest_positions[v];
  return x;
}

/// Replaces the values of free vertices in `to`.
void replace_free(const Model& model, const std::vector<Eigen::Vector3d>& from, std::vector<Eigen::Vector3d>& to) {
  const std::vector<char> held = model.held();
  for (std::size_t v = 0; v < to.size(); ++v)
    if (!held[v]) to[v] = from[v];
}

}  // namespace

std::vector<double> Simulation::positions() const {
  return impl_->call([](fascia::Simulation& simulation) { return numbers_of(positions_of(simulation)); });
}

std::vector<double> Simulation::velocities() const {
  return impl_->call([](fascia::Simulation& simulation) { return numbers_of(simulation.state().velocity); });
}

void Simulation::read_positions(std::span<double> to) const {
  impl_->call([&](fascia::Simulation& simulation) { copy(positions_of(simulation), to, "read_positions"); });
}

void Simulation::read_positions(std::span<float> to) const {
  impl_->call([&](fascia::Simulation& simulation) { copy(positions_of(simulation), to, "read_positions"); });
}

void Simulation::read_velocities(std::span<double> to) const {
  impl_->call([&](fascia::Simulation& simulation) { copy(simulation.state().velocity, to, "read_velocities"); });
}

void Simulation::read_velocities(std::span<float> to) const {
  impl_->call([&](fascia::Simulation& simulation) { copy(simulation.state().velocity, to, "read_velocities"); });
}

void Simulation::set_positions(std::span<const double> positions) {
  std::vector<Eigen::Vector3d> displacement = vectors_of(positions, vertex_count(), "set_positions");
  impl_->call([&](fascia::Simulation& simulation) {
    for (std::size_t v = 0; v < displacement.size(); ++v) displacement[v] -= simulation.model.rest_positions[v];
    fascia::State state = simulation.state();
    replace_free(simulation.model, displacement, state.displacement);
    simulation.go_on_from(state);
  });
}

void Simulation::set_velocities(std::span<const double> velocities) {
  const std::vector<Eigen::Vector3d> velocity = vectors_of(velocities, vertex_count(), "set_velocities");
  impl_->call([&](fascia::Simulation& simulation) {
    fascia::State state = simulation.state();
    replace_free(simulation.model, velocity, state.velocity);
    simulation.go_on_from(state);
  });
}

State Simulation::save() const {
  return impl_->call([](fascia::Simulation& simulation) {
    const fascia::State state = simulation.state();
    return State{numbers_of(state.displacement), numbers_of(state.velocity), state.time,
                 std::make_shared<State::Carried>(state.earlier, state.contact)};
  });
}

void Simulation::restore(const State& state) {
  fascia::State own;
  own.displacement = vectors_of(state.displacements, vertex_count(), "restore: displacements");
  own.velocity = vectors_of(state.velocities, vertex_count(), "restore: velocities");
  own.time = state.time;
  if (!std::isfinite(own.time) || own.time < 0) throw Error("restore: time", "is no time", "expected seconds from 0");
  if (state.carried) {
    const std::size_t earlier = state.carried->earlier.displacement.size();
    if (earlier == 0 || earlier == vertex_count()) own.earlier = state.carried->earlier;
    own.contact = state.carried->contact;
  }
  impl_->call([&](fascia::Simulation& simulation) { simulation.go_on_from(own); });
}

void Simulation::write(const std::string& path) const {
  impl_->call([&](fascia::Simulation& simulation) {
    const std::string renderer =
        simulation.uses_reference() ? "reference solver, double precision" : impl_->context.renderer();
    write_state(path, simulation.model, export_fields(simulation, simulation.state(), path),
                provenance_of(simulation.scene, simulation.model, renderer, "libfascia", simulation.steps_made(),
                              simulation.time()));
  });
}

unsigned Simulation::position_buffer() {
  return impl_->call([](fascia::Simulation& simulation) {
    if (!simulation.gpu())
      throw Error("position_buffer", "there is no GPU", "expected a simulation with an OpenGL context");
    simulation.gpu()->publish();
    const gl::Buffer& positions = simulation.gpu()->positions();
    gl::make_barrier(GL_ALL_BARRIER_BITS);  // the caller may read the buffer in any form
    positions.shader_access().read_by_others();
    return static_cast<unsigned>(positions.id());
  });
}

}  // namespace fascia::api
