// Solver settings: every number that a user can change, listed once with unit, range and help.
#pragma once
#include "sim/integrators/integrator.h"
#include "sim/scene/settings/solver_choice.h"

namespace fascia {

constexpr int kLargestWindow = 10;  // of Anderson acceleration

struct SolverSettings {
  Method method = Method::two_level;
  Acceleration acceleration = Acceleration::subspace;
  Integrator integrator = Integrator::implicit_euler;
  int iterations = 10;            // per stage of a substep, at most
  double tolerance = 0;           // relative residual at which a step's iterations stop; 0: all are run
  double time_step = 1.0 / 60.0;  // dt [s] of a frame step
  int substeps = 1;               // parts of a step
  double frame_budget = 0;        // [ms] that a step may take: it gets the iterations that fit; 0: no limit
  int colors = 0;  // for gauss_seidel; 0: as many as the mesh needs, else phantoms limit them to this number
  double spectral_radius = 0;  // of the plain iteration, for chebyshev; 0: estimated during the run
  int window = 5;              // earlier iterations that Anderson acceleration combines
  // [1/s] scene sizes per second; tissue that stays slower for a while sleeps; 0: nothing sleeps
  double rest_speed = 1e-5;
  bool operator==(const SolverSettings&) const = default;

  double substep() const { return time_step / substeps; }  // h [s]
  /// l [s] of the stages of a substep after another one like it (sim/integrators/stage.h).
  double stage_length() const { return stages_of(integrator, substep(), substep()).front().length; }
  int stages_per_step() const { return substeps * info_of(integrator).stages; }
  SolverChoice choice() const { return {method, acceleration}; }
};

/// f(field, name, unit, min, max, logarithmic, help) for the numeric fields; method and acceleration
/// (solver_choice.h) and integrator are named choices.
template <class S, class F>
void visit_settings(S& s, F&& f) {
  f(s.iterations, "iterations", "", 1, 10000, true, "sweeps over all tets per substep: more is stiffer and slower");
  f(s.tolerance, "tolerance", "", 0.0, 1.0, false,
    "relative residual at which a step stops early; 0 runs all iterations");
  f(s.time_step, "time_step", "s", 1e-6, 1.0, true, "simulated time per step");
  f(s.substeps, "substeps", "", 1, 1000, true, "parts a step is cut into: accurate and stiff, at proportional cost");
  f(s.frame_budget, "frame_budget", "ms", 0.0, 10000.0, false,
    "wall time a step may take: it gets as many of the iterations as fit, one at least; 0 runs all of them. What runs "
    "then depends on the machine's speed");
  f(s.colors, "colors", "", 0, 64, false,
    "dispatches of a sweep; 0: as many as the mesh needs. Fewer split vertices into phantoms (Fratarcangeli, Pellacini "
    "2015): cheaper where a dispatch is dear, slower to converge");
  f(s.spectral_radius, "spectral_radius", "", 0.0, 0.9999, false,
    "factor by which a plain iteration shrinks the slowest error; 0: estimated from the decay of the residual. Too "
    "high overshoots, too low accelerates little");
  f(s.window, "window", "", 1, kLargestWindow, false,
    "earlier iterations that are combined: more converge in fewer iterations, at two dot products each");
  f(s.rest_speed, "rest_speed", "1/s", 0.0, 1.0, false,
    "sizes of the scene per second: what moves slower for a quarter of a second sleeps, and costs nothing until "
    "something changes; 0: never");
}

}  // namespace fascia
