#include "sim/gpu/self_test/kernel_rows.h"
#include "sim/gpu/self_test/trial_box.h"
#include "sim/gpu/solver.h"
#include "sim/reference/double_xpbd.h"
#include "sim/reference/newton.h"

namespace fascia {
namespace {

constexpr int kSteps = 3;

SolverSettings settings_of(const SolverChoice& choice, int iterations) {
  SolverSettings settings;
  settings.method = choice.method;
  settings.acceleration = choice.acceleration;
  settings.iterations = iterations;
  return settings;
}

const SolverChoice kSubspace{Method::two_level, Acceleration::subspace};

/// Of the displacements after some steps from rest.
double step_deviation(gl::ProgramCache& programs, const Model& model, const SolverSettings& settings,
                      const std::vector<GrabSpring>& springs = {}) {
  GpuSolver solver(programs, model, settings);
  reference::NewtonSolver exact(model, settings);
  solver.set_grab(springs);
  exact.set_springs(springs);
  State state = initial_state(model);
  for (int step = 0; step < kSteps; ++step) {
    solver.step();
    exact.step(state);
  }
  return relative_deviation(solver.download().displacement, state.displacement);
}

double damped_deviation(gl::ProgramCache& programs, bool quadratic) {
  return step_deviation(programs, trial_box(trial_tissue(MaterialModel::squared, 0.02), quadratic),
                        settings_of(kSubspace, 20));
}

double materials_deviation(gl::ProgramCache& programs) {
  Model model = trial_box(trial_tissue(MaterialModel::squared));
  model.materials.push_back({2e5, 0.3, 1200, 0, MaterialModel::stable_neo_hookean});
  model.material_names.push_back("stiff");
  model.bodies[0].material_count = 2;
  for (std::size_t t = 0; t < model.tets.size(); ++t)
    if (model.rest_positions[model.tets[t][0]].y() > 0.05) model.tet_material[t] = 1;
  return step_deviation(programs, model, settings_of(kSubspace, 20));
}

double grabbed_deviation(gl::ProgramCache& programs) {
  const Model model = trial_box(trial_tissue(MaterialModel::squared));
  const auto last = static_cast<std::uint32_t>(model.rest_positions.size() - 1);
  return step_deviation(programs, model, settings_of(kSubspace, 20), {{last, {0, 0.02, 0.01}, 50, 0}});
}

/// A ball presses the box from above.
double contact_deviation(gl::ProgramCache& programs, double friction) {
  Model model = trial_box(trial_tissue(MaterialModel::squared));
  Tool ball;
  ball.name = "ball";
  ball.shape = SphereShape{{0, 0, 0}, 0.03};
  ball.friction = friction;
  ball.path = {{0, {0.07, 0.128, 0.05}, {0, 0, 0}}, {0.05, {0.07, 0.115, 0.05}, {0, 0, 0}}};
  model.tools = {ball};
  return step_deviation(programs, model, settings_of(kSubspace, 60));
}

double integrator_deviation(gl::ProgramCache& programs) {
  SolverSettings settings = settings_of(kSubspace, 20);
  settings.integrator = Integrator::bdf2;
  return step_deviation(programs, trial_box(trial_tissue(MaterialModel::squared)), settings);
}

double tolerance_deviation(gl::ProgramCache& programs) {
  SolverSettings settings = settings_of(kSubspace, 40);
  settings.tolerance = 1e-4;
  return step_deviation(programs, trial_box(trial_tissue(MaterialModel::squared)), settings);
}

/// Of a method's own iterations, written from their definition.
double transcribed_deviation(gl::ProgramCache& programs, const SolverChoice& choice) {
  const Model model = trial_box(trial_tissue(MaterialModel::st_venant_kirchhoff));
  const SolverSettings settings = settings_of(choice, 10);
  GpuSolver solver(programs, model, settings);
  reference::DoubleXpbd exact(model, settings);
  State state = initial_state(model);
  for (int step = 0; step < kSteps; ++step) {
    solver.step();
    exact.step(state);
  }
  return relative_deviation(solver.download().displacement, state.displacement);
}

struct MethodRow {
  Method method;
  const char* kernels;
  MaterialModel law;
  int iterations;  // thrice as many without acceleration; 0: against the transcription of the method
  double bound;
};
constexpr MethodRow kMethods[] = {
    {Method::two_level, "block_inverse, coarse_*, two_level_correct, subspace_*", MaterialModel::squared, 12, 1e-4},
    {Method::vertex_descent, "vertex_descent", MaterialModel::squared, 150, 1e-4},
    {Method::exact_xpbd, "exact_tet, exact_vertex", MaterialModel::st_venant_kirchhoff, 150, 1e-3},
    {Method::jacobi, "jacobi_tet, jacobi_vertex", MaterialModel::st_venant_kirchhoff, 0, 1e-4},
    {Method::gauss_seidel, "gauss_seidel", MaterialModel::st_venant_kirchhoff, 0, 1e-4},
    {Method::mass_splitting, "jacobi_tet, predict (MASS_SPLITTING)", MaterialModel::st_venant_kirchhoff, 0, 1e-4},
};

}  // namespace

std::vector<KernelRow> whole_steps() {
  std::vector<KernelRow> rows;
  for (const MethodRow& row : kMethods)
    for (const SolverChoice& choice : solver_choices()) {
      if (choice.method != row.method) continue;
      const std::string with = std::string(" (") + name_of(choice.method) + " + " + name_of(choice.acceleration) + ")";
      rows.push_back({row.kernels + with, row.bound, [&row, choice](gl::ProgramCache& programs) {
                        if (row.iterations == 0) return transcribed_deviation(programs, choice);
                        const int times = choice.acceleration == Acceleration::none ? 3 : 1;
                        return step_deviation(programs, trial_box(trial_tissue(row.law)),
                                              settings_of(choice, times * row.iterations));
                      }});
    }
  rows.push_back({"quadratic_curvature, quadratic_force (two_level)", 1e-4, [](gl::ProgramCache& programs) {
                    return step_deviation(programs, trial_box(trial_tissue(MaterialModel::squared), true),
                                          settings_of(kSubspace, 30));
                  }});
  rows.push_back({"previous_strain (damping)", 1e-4,
                  [](gl::ProgramCache& programs) { return damped_deviation(programs, false); }});
  rows.push_back({"quadratic_strain (damping)", 1e-4,
                  [](gl::ProgramCache& programs) { return damped_deviation(programs, true); }});
  rows.push_back({"feature_material (two materials)", 1e-4, materials_deviation});
  rows.push_back({"grab_load, grab_measure (a grab)", 1e-4, grabbed_deviation});
  rows.push_back(
      {"contact_* (a ball)", 1e-4, [](gl::ProgramCache& programs) { return contact_deviation(programs, 0); }});
  // Which points stick is settled step by step.
  rows.push_back(
      {"contact_finish (friction)", 1e-2, [](gl::ProgramCache& programs) { return contact_deviation(programs, 0.3); }});
  rows.push_back({"predict, velocity (bdf2)", 1e-4, integrator_deviation});
  rows.push_back({"stop_residual, stop_decide (tolerance)", 1e-3, tolerance_deviation});
  return rows;
}

}  // namespace fascia
