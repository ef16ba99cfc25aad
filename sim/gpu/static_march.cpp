#include "sim/gpu/static_march.h"

#include <algorithm>
#include <cmath>

#include "sim/reference/held_path.h"
#include "sim/reference/static_residual.h"

namespace fascia {
namespace {

constexpr int kIterations = 30;  // of the method per step
constexpr int kPatience = 12;    // steps without progress before the march ends
// Of the body's size: a smaller displacement counts as none. A slender body topples slowly at a constant residual
constexpr double kStill = 1e-4;
constexpr int kMostSteps = 400;
constexpr double kFirstStep = 1.0 / 30;  // [s]
constexpr double kLongestStep = 300;     // [s] inertia vanishes for objects of tabletop size

// What remains of a path to equilibrium: motions between two times, and springs that pull tissue from where it is.
struct Path {
  double begin, end;  // [s]
  std::vector<GrabSpring> springs;
  std::vector<Eigen::Vector3d> from;  // [spring] displacement [m]

  std::vector<GrabSpring> springs_at(double share) const {
    std::vector<GrabSpring> part = springs;
    for (std::size_t s = 0; s < part.size(); ++s) part[s].target = from[s] + share * (springs[s].target - from[s]);
    return part;
  }
};

/// Enough increments that no prescribed vertex and no spring moves by more than a third of a tet's width at once.
int increments(const Model& model, const Path& way, double volume) {
  double farthest = 0;
  for (const Motion& motion : model.motions) {
    const double begin = std::max(motion.start, way.begin), end = std::min(motion.start + motion.duration, way.end);
    for (std::size_t k = 0; k < motion.vertices.size() && end > begin; ++k) {
      const Eigen::Vector3d& rest = model.rest_positions[motion.vertices[k]];
      double path = 0;
      Eigen::Vector3d last = motion.position(k, rest, begin);
      for (int part = 1; part <= 8; ++part) {
        const Eigen::Vector3d next = motion.position(k, rest, begin + (end - begin) * part / 8);
        path += (next - last).norm();
        last = next;
      }
      farthest = std::max(farthest, path);
    }
  }
  for (std::size_t s = 0; s < way.springs.size(); ++s)
    farthest = std::max(farthest, (way.springs[s].target - way.from[s]).norm());
  const double width = std::cbrt(6 * volume / static_cast<double>(model.tets.size()));
  return std::clamp(static_cast<int>(std::ceil(3 * farthest / width)), 1, 300);
}

double farthest_way(const State& from, const State& to) {
  double farthest = 0;
  for (std::size_t v = 0; v < to.displacement.size(); ++v)
    farthest = std::max(farthest, (to.displacement[v] - from.displacement[v]).norm());
  return farthest;
}

// Restores the settings and springs of a solver at the end, also after an exception.
class AsBefore {
 public:
  explicit AsBefore(GpuSolver& solver) : solver_(solver), settings_(solver.settings()), springs_(solver.springs()) {}
  AsBefore(const AsBefore&) = delete;
  AsBefore& operator=(const AsBefore&) = delete;
  ~AsBefore() {
    if (!restored_) try {
        restore();
      } catch (...) {  // the context is lost, and the exception in flight already reports that
      }
  }
  void restore() {
    restored_ = true;
    solver_.set_settings(settings_);
    solver_.set_compensated(false);
    solver_.set_grab(springs_);
    solver_.finish_background();
  }

 private:
  GpuSolver& solver_;
  SolverSettings settings_;
  std::vector<GrabSpring> springs_;
  bool restored_ = false;
};

}  // namespace

reference::NewtonReport march_to_equilibrium(GpuSolver& solver, const Model& model, const MarchGoal& goal,
                                             State& equilibrium, const std::stop_token& stop,
                                             const std::function<void(const reference::NewtonReport&)>& news) {
  reference::require_supports(model);
  AsBefore as_before(solver);
  SolverSettings marching = solver.settings();
  marching.substeps = 1;
  marching.integrator = Integrator::implicit_euler;
  marching.iterations = kIterations;
  marching.time_step = kFirstStep;
  marching.tolerance = 0;
  solver.set_settings(marching);
  solver.set_compensated(true);
  solver.finish_background();

  State state = solver.download();
  reference::NewtonReport report;
  // One step to time `to` with h the step length: the place of the motions then does not depend on h.
  const auto step_to = [&](double to) {
    for (Eigen::Vector3d& v : state.velocity) v.setZero();
    state.time = to - marching.time_step;
    solver.upload(state);
    solver.step();
    state = solver.download();
    report.iterations += kIterations;
    if (news) news(report);
  };

  Path path{state.time, std::max(state.time, goal.until.value_or(model.end_of_motions())), solver.springs(), {}};
  for (const GrabSpring& spring : path.springs) path.from.push_back(state.displacement[spring.vertex]);
  if (path.end > path.begin || !path.springs.empty()) {
    const int count = increments(model, path, solver.buffers().volume);
    for (int k = 1; k <= count && !stop.stop_requested(); ++k) {
      solver.set_grab(path.springs_at(static_cast<double>(k) / count));
      step_to(path.begin + (path.end - path.begin) * k / count);
    }
  }
  State best = state;
  const reference::StaticResidual residual_of(model);
  report.relative_residual = residual_of(state, path.springs);
  double last = report.relative_residual;
  for (int steps = 0, idle = 0; steps < kMostSteps && idle < kPatience && report.relative_residual > goal.tolerance;
       ++steps) {
    if (stop.stop_requested()) break;
    const State before = state;
    step_to(path.end);
    const double residual = residual_of(state, path.springs);
    idle = farthest_way(before, state) > kStill * solver.buffers().size ? 0 : idle + 1;
    if (residual < report.relative_residual) {
      if (residual < 0.9 * report.relative_residual) idle = 0;
      report.relative_residual = residual;
      best = state;
    }
    // Inertia slows the march: the next step is longer, unless this one was already too long for its iterations.
    if (residual < 2 * last && marching.time_step < kLongestStep) {
      marching.time_step *= 2;
      solver.set_settings(marching);
      solver.finish_background();
    }
    last = residual;
  }
  report.converged = report.relative_residual <= goal.tolerance;
  for (Eigen::Vector3d& v : best.velocity) v.setZero();
  best.acceleration.clear();
  best.time = path.end;
  as_before.restore();
  solver.upload(best);
  equilibrium = std::move(best);
  return report;
}

}  // namespace fascia
