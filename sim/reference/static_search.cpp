// Static equilibria of the reference solver: loads and prescribed motions in increments, multipliers in passes, and
// falls of what contact alone supports.
//
// A fall is a step of implicit Euler from rest. Its contact is that of where it starts, so that a long one knows
// nothing of what lies on the way. Each is therefore looked at afterwards (sim/contact/passing/clear_way.h), and one
// that leads through something is done again for half as long. Tissue that is held and sags through other tissue falls
// so, too.
#include <algorithm>
#include <utility>

#include "base/error.h"
#include "sim/contact/passing/borne_bodies.h"
#include "sim/reference/newton_impl.h"
#include "sim/tool/tool_approach.h"

namespace fascia::reference {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

// Where nothing bounces, a stiffer penalty takes fewer passes over the multipliers.
constexpr double static_penalty = 100;
constexpr int most_passes = 60;         // since the last fall that was shortened
constexpr double first_fall = 1e-2;     // [s]
constexpr double shortest_fall = 1e-7;  // [s] far below what a body takes for a skin's width
constexpr int most_shortened = 100;     // falls; a landing from three sizes takes about ten, one that tips over twenty
constexpr int kept_length = 4;          // falls after a shortened one that are as long: the next size up failed
constexpr int fall_patience = 100;      // Newton iterations after which a shorter fall is tried, once one was shortened
constexpr int search_patience =
    1000;                             // the same of all falls since the first shortened one: landings take some hundred
constexpr int retry_patience = 2500;  // the same of all parts of a motion that led through something
constexpr double hindering = 1e-3;    // share of the change of forces in a pass by which inertia hinders rest
constexpr double steady_forces = 1e-9;   // change of the forces of contact in a pass, relative to the largest one
constexpr double passing_forces = 1e-2;  // the same on the way of tools, where equilibria only start the next part
constexpr double rounded_forces = 1e-5;  // the same where rounding is what changes them
constexpr double borne_at_rest = 1e-5;   // force of inertia in bodies that have landed, relative to the largest one
constexpr double farthest_fall = 1e4;    // sizes of the tissue: beyond it nothing lands or stops
constexpr double shortest_part = 1.0 / 1024;  // of the time of a motion that leads through something

}  // namespace

void NewtonSolver::Impl::settle_forces(Potential potential, const std::vector<double>& stiffness,
                                       const ToolMotion& motion, bool lands, double tolerance, double steady,
                                       NewtonReport& report, ContactMemory& memory, VectorXd& u) {
  const VectorXd begin = potential.start;
  VectorXd start = begin;                                           // from where friction counts
  double change = 0, unsteady = 0, largest = 0, fall = first_fall;  // [N], [N], [N], [s]
  VectorXd from = u, inertia = VectorXd::Zero(u.size());
  int shortened = 0, keep = 0, searched = 0;
  bool went_through = false;                // a fall was shortened for what it went through
  ToolMotion passed = motion;               // of the tools until the end of the next minimization
  if (u != begin) passed.from = passed.to;  // a way that was looked at before
  const auto borne = [&] { return inertia.cwiseProduct(u - from).lpNorm<Eigen::Infinity>(); };  // [N] by falling
  const auto fall_from = [&](const VectorXd& place) {
    potential.target = from = place;
    potential.inertia = inertia = mass / (fall * fall);
    for (const GrabSpring& spring : springs) add(spring, potential);
  };
  // Tissue that slides along tissue meets other faces.
  const auto contact_at_u = [&] {
    return contact_from(pairs.empty() ? start : u, as_vectors(u), stiffness, motion, memory);
  };
  const auto minimize = [&] {
    for (;;) {
      VectorXd trial = u;
      const int most = shortened > 0 ? fall_patience : last_patience, before = report.iterations;
      report.go_on(minimizer.minimize(potential, tolerance, {most, false, stop}, trial));
      if (shortened > 0) searched += report.iterations - before;
      report.goes_through = !clear(u, trial, passed);
      if (report.goes_through && !clear.of_moving_tools(u, trial, passed)) {  // shorter ways of the tools may help
        report.converged = false;
        return;
      }
      const bool serves = !report.goes_through && (report.converged || !lands);
      if (serves || stop.stop_requested()) {
        u = std::move(trial);
        passed.from = passed.to;
        return;
      }
      went_through |= report.goes_through;
      if (!std::exchange(lands, true)) from = u;
      fall /= 2;
      keep = kept_length;
      if (fall < shortest_fall || ++shortened > most_shortened || searched > search_patience) {
        report.goes_through = went_through;
        report.converged = false;
        return;
      }
      fall_from(from);
      start = u;
      potential.contact = contact_at_u();
    }
  };
  for (int pass = 0; pass < most_passes && report.converged; ++pass) {
    unsteady = borne();
    if (lands) {
      const bool hindered = unsteady > 0.1 * borne_at_rest * largest || unsteady > hindering * change;
      if (pass > 0 && keep-- <= 0 && (shortened == 0 || hindered)) fall *= 2;
      fall_from(u);
    }
    if (lands && pass == 0) {
      minimize();
      if (!report.converged) break;
      unsteady = borne();
    }
    const ContactMemory before = std::exchange(memory, potential.contact->memory_after(u));
    read_out(potential.contact, u);
    const double previous = std::exchange(change, unsteady);
    largest = lands ? weight.lpNorm<Eigen::Infinity>() : 0;  // of a vertex
    for (std::size_t row = 0; row < memory.size(); ++row) {
      if (row >= contact.row_count && (row - contact.row_count) % 5 == 4) continue;  // what pairs met
      const ContactForce old = before.empty() ? ContactForce{} : before[row];
      change =
          std::max({change, std::abs(memory[row].normal - old.normal), (memory[row].friction - old.friction).norm()});
      largest = std::max(largest, memory[row].normal);
    }
    if (change <= steady * largest) return;
    if (change <= rounded_forces * largest && change > 0.5 * previous && change <= potential.contact->rounding(u))
      return;
    if (lands && (u - begin).lpNorm<Eigen::Infinity>() > farthest_fall * size) break;
    if (searched > search_patience) {
      report.goes_through = went_through;
      report.converged = false;
      return;
    }
    potential.contact = contact_at_u();
    const int before_pass = shortened;
    minimize();
    if (shortened > before_pass) pass = 0;
  }
  if (!report.converged || unsteady <= std::max(borne_at_rest, tolerance) * largest) return;
  report.rests = report.converged = false;
}

NewtonReport NewtonSolver::Impl::solve_static(State& state, double tolerance, std::optional<double> until) {
  if (!touches()) require_supports(model);
  const double begin = state.time;
  const double end = std::max(begin, until ? *until : std::max(model.end_of_motions(), model.end_of_tools()));
  const double moment = until ? 1e-9 : 1e-3;  // [s] of a path to a time that has come
  const auto motion = [&](double from, double to) {
    if (!tools || begin == end) return motion_within(from, to);
    return tools->part((from - begin) / (end - begin), (to - begin) / (end - begin));
  };
  const auto depth = [&](std::size_t tool, const ToolPlace& place) {
    return depth_in_tissue(model, contact, state.displacement, tool, place);
  };
  NewtonReport report;
  const BorneBodies borne_bodies(model, contact);
  const double shortest = shortest_part * (end - begin);
  int in_vain = 0;  // Newton iterations
  for (const double time : approach_times(model.tools, contact.finest_parts, begin, end, size, motion, depth)) {
    double part = time - state.time;  // [s]
    do {
      const auto to = [&] { return state.time + part < time - 0.5 * shortest ? state.time + part : time; };
      const VectorXd u = flattened(state.displacement);
      VectorXd carried = u;
      ToolMotion way, rest;  // of all tools, and of those that carry nothing
      const auto is_clear = [&] {
        rest = way = motion(state.time, to());
        carried = u;
        borne_bodies.carry(state.contact, carried, rest);
        return clear.of_moving_tools(u, carried, way) && (carried == u || clear(u, carried, way));
      };
      while (!is_clear() && part > shortest) part /= 2;
      State next = state;
      next.displacement = as_vectors(carried);
      const int before = report.iterations;
      const bool passes = to() < end;
      report = equilibrium(next, passes ? std::max(tolerance, increment_tolerance) : tolerance,
                           passes ? passing_forces : steady_forces, to(), moment, rest);
      if (report.goes_through) in_vain += report.iterations;
      report.iterations += before;
      // What a script or a tool moves through tissue at once may push it aside in shorter parts.
      if (report.goes_through && in_vain < retry_patience && part > shortest && !stop.stop_requested()) {
        part /= 2;
        continue;
      }
      state = std::move(next);
      if (!report.converged || stop.stop_requested()) return report;
      part = std::min(2 * part, time - state.time);
    } while (state.time < time);
  }
  return report;
}

NewtonReport NewtonSolver::Impl::equilibrium(State& state, double tolerance, double steady, double end, double moment,
                                             const ToolMotion& motion) {
  VectorXd u = flattened(state.displacement), internal;
  const HeldPath path(model, u, state.time, std::max(end, state.time + moment));

  // The state is in equilibrium with a part of the load; the rest is added as s increases to 1.
  system.evaluate(u, {}, internal);
  const VectorXd missing = weight - internal, start = u, zero = VectorXd::Zero(u.size());
  std::vector<double> stiffer = penalty;
  for (double& k : stiffer) k *= static_penalty;
  bool lands = touches() && unconstrained_parts(model, model.held()).parts > 0;
  // Inertia holds what nothing else holds while a script moves other tissue, which may push it.
  const VectorXd holds = lands ? VectorXd(mass / (first_fall * first_fall)) : zero;
  const auto loaded = [&](double s, const VectorXd& inertia) {
    Potential result{{}, inertia, start, start, weight - (1 - s) * missing};
    if (touches()) result.contact = contact_from(start, as_vectors(start), stiffer, motion.part(0, s), state.contact);
    for (const GrabSpring& spring : springs) {  // their displacement is also applied gradually
      const Vector3d from = start.segment<3>(3 * static_cast<Eigen::Index>(spring.vertex));
      GrabSpring now = spring;
      now.target = from + s * (spring.target - from);
      add(now, result);
    }
    return result;
  };
  if (tolerance <= 0) tolerance = NewtonSolver::kStaticTolerance;
  NewtonReport report;
  report.converged = true;
  if (!lands || path.moves()) {
    report = follow(
        path, [&](double s) { return loaded(s, holds); }, true, tolerance, u);
    report.goes_through = !clear(start, u, motion);
    if (report.goes_through && !path.moves() && clear.of_moving_tools(start, u, motion)) {
      u = start;
      lands = report.converged = true;
      report.goes_through = false;
    }
  }
  if (touches() && !report.goes_through)
    settle_forces(loaded(1, zero), stiffer, motion, lands, tolerance, steady, report, state.contact, u);
  report.goes_through = report.goes_through || clear.cuts(start, u);
  report.converged = report.converged && !report.goes_through;
  state.displacement = as_vectors(u);
  state.velocity.assign(state.displacement.size(), Vector3d::Zero());
  state.acceleration.clear();
  state.earlier = {};
  state.time = end;
  return report;
}

}  // namespace fascia::reference
