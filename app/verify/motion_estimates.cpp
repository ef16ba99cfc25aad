// How good the estimate of the mesh's error over a run is: effectivity, the estimate over the error of the motion.
#include <memory>

#include "app/verify/solids.h"
#include "app/verify/verification.h"
#include "base/text.h"
#include "sim/simulation/errors/mesh_error_in_motion.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

constexpr int kStepsOfRun = 40, kMomentsOfRun = 10;
constexpr int kFineCells = 16;  // cells of the truth, by quadratic tets

/// The beam without damping, a few times as stiff as that of the other tests: let go from level, or thrown sideways
/// without gravity.
struct Throw {
  const char* name;
  Vector3d gravity, velocity;
};
const Throw kLetGo{"let go from level", {0, -9.81, 0}, {0, 0, 0}}, kThrown{"thrown sideways", {0, 0, 0}, {0.2, 0.5, 1}};

std::unique_ptr<Simulation> start(Verification& verification, const Throw& how, int cells, double poisson_ratio,
                                  ElementOrder elements) {
  Model model = hanging_beam(cells, poisson_ratio, elements);
  for (Material& material : model.materials) {
    material.young_modulus = 4e6;
    material.damping = 0;
  }
  model.gravity = how.gravity;
  const std::vector<char> held = model.held();
  for (std::size_t v = 0; v < held.size(); ++v)
    if (!held[v]) model.initial_velocity[v] = how.velocity * model.rest_positions[v].x();
  Scene scene;
  scene.solver.integrator = Integrator::bdf2;
  scene.solver.substeps = 2;
  scene.solver.rest_speed = 0;
  return std::make_unique<Simulation>(scene, std::move(model), verification.bench.graphics.programs.get(), false);
}

/// At the vertices of the coarsest mesh, which all have.
Trajectory run(Simulation& simulation) {
  Trajectory motion;
  for (int step = 1; step <= kStepsOfRun; ++step) {
    simulation.step();
    if (step % (kStepsOfRun / kMomentsOfRun) != 0) continue;
    const State state = simulation.state();
    motion.displacement.emplace_back();
    for (int i = 0; i <= 4; ++i)
      for (int j = 0; j <= 1; ++j)
        for (int k = 0; k <= 1; ++k)
          motion.displacement.back().push_back(displacement_at(simulation.model, state, 0.25 * Vector3d(i, j, k)));
  }
  return motion;
}

}  // namespace

void verify_estimates_in_motion(Verification& verification) {
  const char* const kTest = "Estimated error of the mesh over a run";
  for (const Throw& how : {kLetGo, kThrown})
    for (const double nu : {0.3, 0.45}) {
      const auto fine = start(verification, how, kFineCells, nu, ElementOrder::quadratic);
      const Trajectory truth = run(*fine);
      for (const auto& [elements, cells] : {std::pair(ElementOrder::linear, 8), std::pair(ElementOrder::linear, 16),
                                            std::pair(ElementOrder::quadratic, 4)}) {
        const auto coarse = start(verification, how, cells, nu, elements);
        const double error = error_of(run(*coarse), truth).over_run;
        const RunError estimate = estimate_mesh_error_in_motion(*coarse, verification.bench.graphics.programs.get());
        verification.add({kTest,
                          "beam " + std::string(how.name) + ", " + count_of(coarse->model) + ", nu = " + number(nu) +
                              ": estimate over error",
                          "", estimate.over_run / error, 0.7, 1.5,
                          "error " + number(100 * error) + " % of the displacements over " +
                              std::to_string(kStepsOfRun) + " steps, against " + count_of(fine->model)});
      }
    }
}

}  // namespace fascia
