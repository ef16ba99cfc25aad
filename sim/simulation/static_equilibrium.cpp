#include "sim/simulation/static_equilibrium.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <future>
#include <iostream>
#include <sstream>

#include "base/error.h"
#include "sim/gpu/static_march.h"
#include "sim/model/unconstrained_parts.h"
#include "sim/simulation/simulation.h"

namespace fascia {
namespace {

StaticReport report_of(const reference::NewtonReport& newton, double tolerance) {
  return {0,
          newton.iterations,
          newton.relative_residual,
          newton.converged,
          tolerance > 0 ? tolerance : reference::NewtonSolver::kStaticTolerance,
          newton.rests,
          newton.goes_through};
}

/// What a search that found no equilibrium would need.
std::string missing_in(const Simulation& simulation, const StaticReport& report) {
  const UnconstrainedParts free = unconstrained_parts(simulation.model, simulation.model.held());
  constexpr double kNearly = 1e-4;  // relative residual of a state that is one in all but its last digits
  if (report.goes_through) return "what meets to be kept apart, as steps of a motion do (fascia run without --static)";
  if (!report.rests)
    return "contact and friction that hold what has no fixed vertices (" + vertex_name(simulation.model, free.first) +
           ")";
  if (report.relative_residual <= kNearly) {
    std::ostringstream tolerance;
    tolerance << std::pow(10.0, std::ceil(std::log10(report.relative_residual)));
    return "a tolerance within reach, such as --set solver.tolerance=" + tolerance.str();
  }
  return free.parts > 0 && !simulation.model.has_contact() ? "a constrained body and a load that it can carry"
                                                           : "a load that supports and contact can carry";
}

}  // namespace

StaticReport Simulation::solve_static(const std::function<void(const StaticReport&)>& news, std::stop_token stop,
                                      std::optional<double> until) {
  if (!model.has_contact() && !model.gravity.isZero(0))
    if (const UnconstrainedParts free = unconstrained_parts(model, model.held()); free.parts > 0)
      throw Error(scene.file.string(),
                  "has no static equilibrium: a component of the mesh (" + vertex_name(model, free.first) +
                      ") is unconstrained",
                  "expected fixed or prescribed vertices in every component, contact that holds it, or no gravity");
  pull(until ? with_grabs(other_springs_, model.grabs, *until) : with_grabs_at_last(other_springs_, model.grabs));
  // Waits on this thread, to send news: Newton's method itself sends none.
  const auto with_news = [&](int iterations, const std::function<reference::NewtonReport()>& solve) {
    if (!news) return solve();
    std::future<reference::NewtonReport> running = std::async(std::launch::async, solve);
    while (running.wait_for(std::chrono::seconds(1)) != std::future_status::ready) news({iterations, 1, 0});
    return running.get();
  };
  int marched = 0;  // iterations before Newton's method
  const auto by_newton = [&](reference::NewtonSolver& solver, State& state, double tolerance) {
    solver.set_springs(springs_);
    if (!led_.empty()) solver.set_tools(led_.motion(model.tools, time(), std::max(time(), model.end_of_tools())));
    return with_news(marched, [&] { return solver.solve_static(state, tolerance, until); });
  };
  if (reference_) {  // which then has the forces of contact
    reference_->set_stop(stop);
    newton_report_ = by_newton(*reference_, reference_state_, scene.solver.tolerance);
    reference_->set_stop(interrupt_token());
    if (gpu_) gpu_->upload(reference_state_);
    return report_of(newton_report_, scene.solver.tolerance);
  }
  if (model.has_contact()) {  // the march has no multipliers to repeat
    if (model.tets.size() > reference::NewtonSolver::kMostTets)
      throw Error(scene.file.string(), "has contact and " + std::to_string(model.tets.size()) + " tets",
                  "expected at most " + std::to_string(reference::NewtonSolver::kMostTets) +
                      " for a static equilibrium in contact");
    State exact = gpu_->download();
    reference::NewtonSolver solver(model, scene.solver, stop);
    const reference::NewtonReport newton = by_newton(solver, exact, scene.solver.tolerance);
    if (newton.converged) {
      gpu_->settle(exact);
      equilibrium_contact_ = {{solver.tool_loads(), solver.pair_loads()}, solver.contact_forces()};
    }
    return report_of(newton, scene.solver.tolerance);
  }
  const double tolerance = scene.solver.tolerance > 0 ? scene.solver.tolerance : 1e-5;
  equilibrium_.emplace();
  const auto tell_news = [&](const reference::NewtonReport& report) {
    if (news) news({report.iterations, 0, report.relative_residual, false, tolerance});
  };
  const reference::NewtonReport march =
      march_to_equilibrium(*gpu_, model, {tolerance, until}, *equilibrium_, stop, tell_news);
  StaticReport report{march.iterations, 0, march.relative_residual, march.converged};
  constexpr std::size_t kSoonFactored = 20'000;  // tets: factorized in about a second
  // A small residual may mean a large error in bodies that bend easily, and Newton's last iterations remove it.
  const bool exactly = scene.solver.tolerance == 0 && model.tets.size() <= kSoonFactored;
  const bool refines = march.converged && exactly;
  // Slender bodies of many tets, whose equilibria the march nears slowly, take Newton's method some iterations.
  const bool rescues = !march.converged && model.tets.size() <= reference::NewtonSolver::kMostTets &&
                       unconstrained_parts(model, model.held()).parts == 0;
  if (stop.stop_requested() || !(refines || rescues)) return report;
  marched = march.iterations;
  State exact = *equilibrium_;
  reference::NewtonSolver solver(model, scene.solver, stop);
  const reference::NewtonReport newton = by_newton(solver, exact, exactly ? 0 : tolerance);
  report.newton_iterations = newton.iterations;
  if (!newton.converged) return report;
  report.relative_residual = newton.relative_residual;
  report.converged = true;
  if (exactly) report.tolerance = reference::NewtonSolver::kStaticTolerance;
  gpu_->upload(exact);
  equilibrium_ = std::move(exact);
  return report;
}

std::string describe(const StaticReport& report) {
  std::ostringstream text;
  text << (report.converged ? "static equilibrium after " : "no static equilibrium after ");
  if (report.iterations > 0) text << report.iterations << (report.newton_iterations > 0 ? " and " : " ");
  if (report.newton_iterations > 0) text << report.newton_iterations << " Newton ";
  if (report.iterations + report.newton_iterations == 0) text << "no ";
  text << (report.iterations + report.newton_iterations == 1 ? "iteration" : "iterations");
  if (report.goes_through)
    text << ": tissue would go through what it meets";
  else if (report.rests)
    text << ", relative residual " << report.relative_residual;
  else
    text << ": bodies without supports go on moving";
  if (report.converged && report.tolerance > 0 && report.relative_residual > report.tolerance)
    text << ", the rounding of double precision";
  return text.str();
}

std::optional<double> seconds_left(double before, double now, double tolerance, double seconds) {
  if (!(tolerance > 0 && now > tolerance && now < before)) return std::nullopt;
  return seconds * std::log(now / tolerance) / std::log(before / now);
}

std::function<void(const StaticReport&)> static_news(bool quiet) {
  if (quiet) return {};
  using Clock = std::chrono::steady_clock;
  static constexpr auto kInterval = std::chrono::seconds(5);
  struct Seen {
    double residual = 0;
    Clock::time_point time;
  };
  return [begin = Clock::now(), last = Clock::now(), first = Seen()](const StaticReport& report) mutable {
    const auto now = Clock::now();
    if (first.residual == 0 && report.relative_residual > 0) first = {report.relative_residual, now};
    if (now - last < kInterval) return;
    last = now;
    std::cerr << "fascia: static equilibrium: ";
    if (report.iterations > 0) std::cerr << report.iterations << " iterations";
    if (report.newton_iterations > 0) {
      std::cerr << (report.iterations > 0 ? ", now " : "") << "by Newton's method in double precision, "
                << std::chrono::duration_cast<std::chrono::seconds>(now - begin).count() << " s" << std::endl;
      return;
    }
    if (report.relative_residual > 0) std::cerr << ", relative residual " << report.relative_residual;
    const double seconds = std::chrono::duration<double>(now - first.time).count();
    if (const auto left = seconds_left(first.residual, report.relative_residual, report.tolerance, seconds))
      std::cerr << " of " << report.tolerance << ", about " << std::ceil(*left) << " s left";
    std::cerr << std::endl;
  };
}

void require_equilibrium(const Simulation& simulation, const StaticReport& report) {
  constexpr double kFloat32 = 1e-3;  // rounding in soft slender bodies, with a margin
  const bool only_march = simulation.model.tets.size() > reference::NewtonSolver::kMostTets;
  if (report.converged || (only_march && report.relative_residual <= kFloat32)) return;
  throw Error(simulation.scene.file.string(), describe(report), "expected " + missing_in(simulation, report));
}

}  // namespace fascia
