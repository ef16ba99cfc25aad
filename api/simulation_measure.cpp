// Measurements of a simulation: on the GPU where it computes there, else by the reference solver's formulas.
#include <limits>

#include "api/simulation.h"
#include "api/values.h"

namespace fascia::api {
namespace {

Diagnostics shown(const fascia::Diagnostics& d) {
  Diagnostics out;
  out.time = d.time;
  out.kinetic = d.kinetic;
  out.elastic = d.elastic;
  out.gravitational = d.gravitational;
  out.volume_ratio = d.volume_ratio;
  out.min_det_f = d.min_det_f;
  out.max_det_f = d.max_det_f;
  out.inverted = d.inverted;
  out.max_strain = d.max_strain;
  out.max_von_mises = d.max_von_mises;
  out.max_speed = d.max_speed;
  out.momentum = array_of(d.momentum);
  out.angular_momentum = array_of(d.angular_momentum);
  out.reaction = array_of(d.reaction);
  out.grab_force = array_of(d.grab_force);
  out.residual = d.residual;
  out.iterations = d.iterations;
  return out;
}

Diagnostics by_reference(const fascia::Simulation& simulation) {
  const fascia::State state = simulation.state();
  const reference::Measures m = reference::measure(simulation.model, state);
  Diagnostics out;
  out.time = state.time;
  out.kinetic = m.kinetic;
  out.elastic = m.elastic;
  out.gravitational = m.gravitational;
  out.volume_ratio = m.volume_ratio;
  out.min_det_f = m.min_det_f;
  out.max_det_f = m.max_det_f;
  out.inverted = m.inverted;
  const StateFields fields = reference::export_fields(simulation.model, state);
  for (const auto& e : fields.green_strain)
    out.max_strain = std::max(out.max_strain, std::sqrt(e.head<3>().squaredNorm() + 2 * e.tail<3>().squaredNorm()));
  for (const double stress : fields.von_mises) out.max_von_mises = std::max(out.max_von_mises, stress);
  for (const Eigen::Vector3d& v : state.velocity) out.max_speed = std::max(out.max_speed, v.norm());
  out.momentum = array_of(m.momentum);
  out.angular_momentum = array_of(m.angular_momentum);
  out.reaction = array_of(m.fixed_reaction);
  Eigen::Vector3d grab = Eigen::Vector3d::Zero();
  for (const HandForce& hand : forces_of_hands(simulation.springs(), state.displacement)) grab += hand.force;
  out.grab_force = array_of(grab);
  out.residual = simulation.newton_report().relative_residual;
  out.iterations = simulation.newton_report().iterations;
  return out;
}

}  // namespace

Diagnostics Simulation::diagnostics() {
  return impl_->call([](fascia::Simulation& simulation) {
    Diagnostics out;
    if (simulation.uses_reference()) {
      out = by_reference(simulation);
    } else {
      simulation.gpu()->request_diagnostics();
      out = shown(*simulation.gpu()->take_diagnostics(true));
    }
    if (simulation.steps_made() == 0) out.residual = std::numeric_limits<double>::quiet_NaN();
    return out;
  });
}

std::vector<Support> Simulation::supports() const {
  return impl_->call([](fascia::Simulation& simulation) {
    std::vector<Support> out;
    for (const reference::Support& s : reference::support_forces(simulation.model, simulation.state()))
      out.push_back({s.body, s.motion, array_of(s.force)});
    return out;
  });
}

TetFields Simulation::tet_fields() const {
  return impl_->call([](fascia::Simulation& simulation) {
    const StateFields fields = reference::export_fields(simulation.model, simulation.state());  // in the order of the files
    TetFields out;
    for (const std::uint32_t source : simulation.model.tet_source) {
      out.von_mises.push_back(fields.von_mises[source]);
      out.det_f.push_back(fields.det_f[source]);
      for (const double e : fields.green_strain[source]) out.green_strain.push_back(e);
    }
    return out;
  });
}

std::vector<double> Simulation::von_mises() const { return tet_fields().von_mises; }

}  // namespace fascia::api
