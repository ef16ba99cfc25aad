#include "sim/gpu/self_test/kernel_rows.h"

#include <algorithm>
#include <cmath>

#include "sim/gpu/integrators/stage.h"
#include "sim/gpu/passes/compute_probe.h"
#include "sim/gpu/passes/step_gradient.h"
#include "sim/gpu/self_test/trial_box.h"
#include "sim/gpu/solver.h"
#include "sim/reference/elastic_system.h"
#include "sim/reference/elasticity.h"
#include "sim/reference/mass_matrix.h"
#include "sim/reference/newton.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

constexpr double kAmplitude = 0.002;  // [m] of the displacements: a tenth of an edge

/// A random state after its prediction.
struct Predicted {
  Predicted(gl::ProgramCache& programs, const Model& of) : model(of), buffers(of), state(trial_state(of, kAmplitude)) {
    buffers.upload_step(model, settings, stage);
    buffers.upload_state(model, state);
    prediction(programs, buffers, nullptr).run();
  }
  const Model& model;
  SolverSettings settings;
  IntegratorStage stage{settings.substep()};
  SimBuffers buffers;
  State state;
};

double predict_deviation(gl::ProgramCache& programs) {
  const Model model = trial_box(trial_tissue(MaterialModel::squared));
  const Predicted p(programs, model);
  const std::vector<char> held = model.held();
  const double h = p.stage.length;
  std::vector<Vector3d> found, expected;
  const std::vector<Vector3d> all = p.buffers.download_vectors(p.buffers.predicted);
  for (std::size_t v = 0; v < held.size(); ++v) {
    if (held[v]) continue;
    found.push_back(all[v]);
    expected.push_back(p.state.displacement[v] + h * p.state.velocity[v] + h * h * model.gravity);
  }
  return relative_deviation(found, expected);
}

/// Of M (u - u~) + h^2 dU/du.
double gradient_deviation(gl::ProgramCache& programs, MaterialModel law, bool quadratic) {
  const Model model = trial_box(trial_tissue(law), quadratic);
  const Predicted p(programs, model);
  const Features features = features_of(model);
  const gl::Buffer no_strain;
  const EnergyTerms no_terms;
  const StepGradient gradient(programs, p.buffers);
  const Recording recording{programs, p.buffers, features, no_strain, no_terms};
  if (quadratic) centroid_prediction(recording).run();
  for (const gl::ComputePass& pass : gradient.passes(recording)) pass.run();
  const std::vector<Vector3d> u = p.buffers.download_vectors(p.buffers.displacement),
                              start = p.buffers.download_vectors(p.buffers.predicted);
  const auto count = static_cast<Eigen::Index>(u.size());
  Eigen::VectorXd force;
  reference::ElasticSystem(model).evaluate(Eigen::Map<const Eigen::VectorXd>(u[0].data(), 3 * count), {}, force);
  const std::vector<char> held = model.held();
  const double squared = p.stage.length * p.stage.length;
  Eigen::VectorXd lag(3 * count);
  for (std::size_t v = 0; v < u.size(); ++v)
    lag.segment<3>(3 * static_cast<Eigen::Index>(v)) = u[v] - start[v] - (held[v] ? squared : 0.0) * model.gravity;
  const Eigen::VectorXd all = reference::MassMatrix(model).times(lag) + squared * force;
  std::vector<Vector3d> expected(u.size(), Vector3d::Zero());
  for (std::size_t v = 0; v < u.size(); ++v)
    if (!held[v]) expected[v] = all.segment<3>(3 * static_cast<Eigen::Index>(v));
  return relative_deviation(p.buffers.download_vectors(gradient.gradient()), expected);
}

/// Of von Mises stresses at the vertices.
double heat_deviation(gl::ProgramCache& programs) {
  const Model model = trial_box(trial_tissue(MaterialModel::squared));
  GpuSolver solver(programs, model, {});
  const State state = trial_state(model, kAmplitude);
  solver.upload(state);
  solver.set_color(ColorBy::von_mises);
  solver.publish();
  std::vector<double> stress(model.rest_positions.size(), 0), around(model.rest_positions.size(), 0);
  for (const Tet& tet : model.tets) {
    const auto& x = model.rest_positions;
    const auto& u = state.displacement;
    const LinearTet rest({x[tet[0]], x[tet[1]], x[tet[2]], x[tet[3]]});
    const double volume = signed_volume6(x[tet[0]], x[tet[1]], x[tet[2]], x[tet[3]]);
    const double of_tet = reference::von_mises(rest.deformation_gradient({u[tet[0]], u[tet[1]], u[tet[2]], u[tet[3]]}),
                                               model.materials[0]);
    for (const std::uint32_t v : tet) {
      stress[v] += volume * of_tet;
      around[v] += volume;
    }
  }
  std::vector<Vector3d> found, expected;
  const auto published = solver.positions().read<shared::vec4>();
  for (std::size_t v = 0; v < stress.size(); ++v) {
    found.emplace_back(published[v].w, 0, 0);
    expected.emplace_back(stress[v] / around[v], 0, 0);
  }
  return relative_deviation(found, expected);
}

/// Of the energies and the volume.
double diagnostics_deviation(gl::ProgramCache& programs, bool quadratic) {
  const Model model = trial_box(trial_tissue(MaterialModel::squared), quadratic);
  GpuSolver solver(programs, model, {});
  const State state = trial_state(model, kAmplitude);
  solver.upload(state);
  solver.request_diagnostics();
  const Diagnostics found = *solver.take_diagnostics(true);
  const reference::Measures expected = reference::measure(model, state);
  double largest = 0;
  for (const auto& [a, b] : {std::pair(found.elastic, expected.elastic), std::pair(found.kinetic, expected.kinetic),
                             std::pair(found.volume_ratio, expected.volume_ratio)})
    largest = std::max(largest, std::isfinite(a) ? std::abs(a / b - 1) : HUGE_VAL);
  return largest;
}

}  // namespace

std::vector<KernelRow> single_kernels() {
  std::vector<KernelRow> rows = {{"fill", 0,
                                  [](gl::ProgramCache& programs) {
                                    require_computing(programs);
                                    return 0.0;
                                  }},
                                 {"predict", 1e-6, predict_deviation}};
  for (const MaterialModel law : material_models())
    rows.push_back({std::string("elastic_force, gradient (") + name_of(law) + ")", 2e-5,
                    [law](gl::ProgramCache& programs) { return gradient_deviation(programs, law, false); }});
  rows.push_back({"quadratic_force, gradient", 2e-5, [](gl::ProgramCache& programs) {
                    return gradient_deviation(programs, MaterialModel::squared, true);
                  }});
  rows.push_back({"heat_tet, publish", 1e-5, heat_deviation});
  rows.push_back({"diagnose_tet, diagnose_vertex", 1e-5,
                  [](gl::ProgramCache& programs) { return diagnostics_deviation(programs, false); }});
  rows.push_back({"quadratic_diagnose, diagnose_vertex", 1e-5,
                  [](gl::ProgramCache& programs) { return diagnostics_deviation(programs, true); }});
  return rows;
}

}  // namespace fascia
