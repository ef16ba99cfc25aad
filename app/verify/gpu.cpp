// The solver on the device at hand, in single precision, against the reference solver.
#include <cmath>

#include "app/verify/solids.h"
#include "app/verify/verification.h"
#include "sim/accuracy/relative_distance.h"
#include "sim/reference/newton.h"
#include "sim/simulation/simulation.h"

namespace fascia {
void verify_gpu(Verification& verification) {
  const char* const kTest = "Solver on the GPU";
  for (const ElementOrder elements : kElementOrders)
    for (const Integrator integrator : {Integrator::implicit_euler, Integrator::bdf2}) {
      const Model model = hanging_beam(elements == ElementOrder::linear ? 16 : 8, 0.3, elements);
      Scene scene;
      scene.solver.integrator = integrator;
      Simulation simulation(scene, model, verification.bench.graphics.programs.get(), false);
      simulation.gpu()->finish_background();
      State exact = initial_state(model);
      reference::NewtonSolver solver(model, scene.solver);
      for (int step = 0; step < 30; ++step) {
        simulation.step();
        solver.step(exact);
      }
      verification.add({kTest,
                        count_of(model) + ", " + name_of(integrator) +
                            ", 30 steps of 10 iterations of a released beam: RMS error of displacement, relative",
                        "", relative_distance(simulation.state().displacement, exact.displacement), 0, 1e-3,
                        "exact steps by the reference solver; bound: what 10 iterations may leave"});
    }
  for (const ElementOrder elements : kElementOrders) {
    const Model model = hanging_beam(elements == ElementOrder::linear ? 24 : 12, 0.3, elements);
    Scene scene;
    scene.solver.tolerance = 1e-5;
    Simulation simulation(scene, model, verification.bench.graphics.programs.get(), false);
    const bool converged = simulation.solve_static().converged;
    verification.add(
        {kTest, count_of(model) + ", static equilibrium: RMS error of displacement, relative", "",
         converged ? relative_distance(simulation.state().displacement, equilibrium(model).displacement) : std::nan(""),
         0, 1e-4, "the reference solver's; bound: ten times the residual of 1e-5"});
  }
}

}  // namespace fascia
