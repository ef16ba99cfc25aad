// What a search for a static equilibrium (Simulation::solve_static) reports, and how that is told.
#pragma once
#include <functional>
#include <string>

namespace fascia {

class Simulation;

/// Of the search for a static equilibrium.
struct StaticReport {
  int iterations = 0, newton_iterations = 0;  // of the scene's method, and of Newton's
  double relative_residual = 0;               // reference::NewtonReport
  bool converged = false;                     // to the tolerance
};

/// "static equilibrium after 12 Newton iterations, relative residual 1e-11"
/// One line.
std::string describe(const StaticReport& report);
/// Says on stderr how far a long solve is, every few seconds.
std::function<void(const StaticReport&)> static_news(bool quiet);
/// Throws Error where it is no equilibrium: neither to the tolerance nor, with a mesh too large for Newton's method, as
/// far as float32 goes.
void require_equilibrium(const Simulation& simulation, const StaticReport& report);

}  // namespace fascia
