// The report of a search for a static equilibrium (Simulation::solve_static), and its messages.
#pragma once
#include <functional>
#include <optional>
#include <string>

namespace fascia {

class Simulation;

/// The result of the search.
struct StaticReport {
  int iterations = 0, newton_iterations = 0;  // of the scene's method, and of Newton's
  double relative_residual = 0;               // reference::NewtonReport
  bool converged = false;                     // to the tolerance
  double tolerance = 0;                       // of relative_residual
  bool rests = true;                          // reference::NewtonReport
  bool goes_through = false;                  // reference::NewtonReport
};

/// "static equilibrium after 12 Newton iterations, relative residual 1e-11"; says where rounding kept it above the
/// tolerance.
/// One line.
std::string describe(const StaticReport& report);
/// Seconds until the residual reaches the tolerance, if it goes on falling as it did during the last `seconds`, in
/// which it fell from `before` to `now`. None while it does not fall.
std::optional<double> seconds_left(double before, double now, double tolerance, double seconds);
/// A callback that reports the progress of a long solve on stderr every few seconds, with an estimate of what is left.
std::function<void(const StaticReport&)> static_news(bool quiet);
/// Throws Error if the state is not an equilibrium: neither to the tolerance nor, with a mesh too large for Newton's
/// method, to the limit of float32. The error states what is missing: supports, a load that they can carry, contact
/// that holds a body, or a tolerance within reach.
void require_equilibrium(const Simulation& simulation, const StaticReport& report);

}  // namespace fascia
