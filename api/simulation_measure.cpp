// Measurements of a simulation: on the GPU if it computes there, else by the reference solver's formulas.
#include <limits>

#include "api/simulation.h"
#include "api/values.h"
#include "sim/accuracy/nodal_stress.h"
#include "sim/output/sample.h"

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

}  // namespace

Diagnostics Simulation::diagnostics() {
  return impl_->call([](fascia::Simulation& simulation) {
    if (!simulation.uses_reference()) simulation.gpu()->request_diagnostics();
    Diagnostics out = shown(simulation.uses_reference() ? diagnostics_by_reference(simulation)
                                                        : *simulation.gpu()->take_diagnostics(true));
    if (simulation.steps_made() == 0) out.residual = std::numeric_limits<double>::quiet_NaN();
    return out;
  });
}

std::vector<Support> Simulation::supports() const {
  return impl_->call([](fascia::Simulation& simulation) {
    std::vector<Support> out;
    for (const reference::Support& s :
         reference::support_forces(simulation.model, simulation.state(), simulation.contact_forces()))
      out.push_back({s.body, s.motion, array_of(s.force)});
    return out;
  });
}

TetFields Simulation::tet_fields() const {
  return impl_->call([](fascia::Simulation& simulation) {
    // In the order of the files
    const StateFields fields = reference::export_fields(simulation.model, simulation.state());
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

RecoveredStress Simulation::recovered_stress() const {
  return impl_->call([](fascia::Simulation& simulation) {
    NodalStress stress = nodal_stress(simulation.model, simulation.state());
    const PeakStress peak = peak_of(stress, simulation.model);
    RecoveredStress out{{}, std::move(stress.von_mises), peak.max, peak.p99};
    for (const auto& cauchy : stress.cauchy) out.cauchy.insert(out.cauchy.end(), cauchy.begin(), cauchy.end());
    return out;
  });
}

}  // namespace fascia::api
