#include "app/refine/plan.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "sim/accuracy/time_extrapolation.h"

namespace fascia {
namespace {

// Steps by which the number of tets doubles; beyond these a measured mesh says little.
constexpr int kCoarsest = -4, kFinest = 9;
constexpr int kSubsteps[] = {1, 2, 4, kMostSubsteps};
constexpr int kIterations[] = {3, 5, 7, 10, 15, 20, kMostIterations};
// A measured step may be unusually good; more iterations than measured are not trusted with more than this.
constexpr double kBestRate = 0.6;  // of the error, per iteration
constexpr double kRounding = 1e-6;
// What a substep takes beside its iterations is measured as a difference of times, which scatter: at most this.
constexpr double kMostBeside = 0.5;  // of the time with `many` iterations
// Times and predictions scatter by about a tenth: less is not worth another trial.
constexpr double kDoubt = 1.1;

bool of_one_kind(const Trial& a, const Trial& b) { return a.elements == b.elements && a.integrator == b.integrator; }

bool same_mesh(double refinement, double other) { return std::abs(std::log(refinement / other)) < 1e-9; }

/// Of the trials of one kind, the one that says most about a choice.
const Trial& nearest(const Trial& kind, const std::vector<Trial>& trials, double refinement, int substeps,
                     int iterations) {
  const auto distance = [&](const Trial& trial) {
    const bool more = trial.substeps > substeps;
    const double mesh = same_mesh(trial.refinement, refinement) ? 0 : std::abs(std::log(trial.refinement / refinement));
    const auto off = [&](int measured) { return std::abs(std::log(static_cast<double>(iterations) / measured)); };
    return std::tuple(more, more ? trial.substeps : -trial.substeps, mesh, -trial.refinement,
                      std::min(off(trial.few), off(trial.many)));
  };
  const Trial* best = nullptr;
  for (const Trial& trial : trials)
    if (of_one_kind(trial, kind) && (!best || distance(trial) < distance(*best))) best = &trial;
  return *best;
}

double shape_error(const Trial& trial, double refinement) {
  return same_mesh(trial.refinement, refinement) ? trial.shape
                                                 : trial.shape * std::pow(trial.refinement / refinement, 2);
}

double shape_error(const std::vector<Trial>& trials, double refinement) {
  const auto distance = [&](const Trial& trial) { return std::abs(std::log(trial.refinement / refinement)); };
  return shape_error(*std::min_element(trials.begin(), trials.end(),
                                       [&](const Trial& a, const Trial& b) { return distance(a) < distance(b); }),
                     refinement);
}

double solver_error(const Trial& trial, int iterations) {
  const double few = std::max(trial.solver_few, kRounding), many = std::max(trial.solver_many, kRounding);
  const double rate = std::pow(many / few, 1.0 / (trial.many - trial.few));
  if (iterations > trial.many) return many * std::pow(std::clamp(rate, kBestRate, 1.0), iterations - trial.many);
  return few * std::pow(iterations < trial.few ? std::min(rate, 1.0) : rate, iterations - trial.few);
}

double ms_of_trial(const Trial& trial, int iterations) {
  if (iterations == trial.few) return trial.ms_few;
  const double tet_substeps = static_cast<double>(trial.tets) * trial.substeps;
  return trial.ms_many + 1e-6 * trial.ns_per_tet_iteration() * tet_substeps * (iterations - trial.many);
}

}  // namespace

double Trial::ns_per_tet_iteration() const {
  const double all = ms_many / many, slope = (ms_many - ms_few) / (many - few);
  return 1e6 * std::clamp(slope, (1 - kMostBeside) * all, all) / (static_cast<double>(tets) * substeps);
}

Proposal predicted(const Trial& trial, double refinement, int substeps, int iterations) {
  Proposal result{trial.elements, trial.integrator, refinement, 0, substeps, iterations};
  const bool own_mesh = same_mesh(refinement, trial.refinement);
  const double finer = own_mesh ? 1 : refinement / trial.refinement;
  const auto tets = static_cast<double>(trial.tets), kept = static_cast<double>(trial.kept);
  result.tets = kept + (tets - kept) * std::pow(finer, 3);
  result.shape = shape_error(trial, refinement);
  const bool steep = trial.elements == ElementOrder::quadratic && finer < 1;
  result.mesh = trial.mesh * std::pow(finer, steep ? -4 : -2);
  result.time = trial.time * std::pow(static_cast<double>(trial.substeps) / substeps,
                                      std::max(trial.order, TimeExtrapolation::kLeastOrder));
  result.solver = std::max(kRounding, solver_error(trial, iterations));
  result.ms = ms_of_trial(trial, iterations) * result.tets / tets * substeps / trial.substeps;
  result.other_mesh = !own_mesh;
  result.from_tets = trial.tets;
  result.measured = own_mesh && substeps == trial.substeps && (iterations == trial.few || iterations == trial.many);
  return result;
}

std::vector<double> usual_refinements() {
  std::vector<double> refinements;
  for (int doublings = kCoarsest; doublings <= kFinest; ++doublings)
    refinements.push_back(std::cbrt(std::pow(2.0, doublings)));
  return refinements;
}

Plan plan_for(const std::vector<Trial>& trials, double error, double ms, const std::vector<double>& refinements,
              const std::function<bool(const Proposal&)>& allowed) {
  Plan plan;
  std::vector<Proposal> all;
  const auto doubtful = [](const Proposal& p, double value) { return p.measured ? value : kDoubt * value; };
  const auto faster = [&](const Proposal& a, const Proposal& b) { return doubtful(a, a.ms) < doubtful(b, b.ms); };
  const auto better = [&](const Proposal& a, const Proposal& b) {
    return doubtful(a, a.error()) < doubtful(b, b.error());
  };
  const auto keep = [](std::optional<Proposal>& best, const Proposal& candidate, const auto& before) {
    if (!best || before(candidate, *best)) best = candidate;
  };
  for (auto kind = trials.begin(); kind != trials.end(); ++kind) {
    if (std::any_of(trials.begin(), kind, [&](const Trial& other) { return of_one_kind(other, *kind); })) continue;
    for (const double refinement : refinements)
      for (const int substeps : kSubsteps)
        for (const int iterations : kIterations) {
          Proposal candidate =
              predicted(nearest(*kind, trials, refinement, substeps, iterations), refinement, substeps, iterations);
          candidate.shape = shape_error(trials, refinement);
          if (!std::isfinite(candidate.error()) || (allowed && !allowed(candidate))) continue;
          if (candidate.error() <= error && candidate.ms <= ms) keep(plan.within, candidate, faster);
          if (candidate.error() <= error) keep(plan.exact, candidate, faster);
          if (candidate.ms <= ms) keep(plan.fast, candidate, better);
          all.push_back(candidate);
          keep(plan.fastest, candidate, faster);
        }
  }
  double least = std::numeric_limits<double>::infinity();
  for (const Proposal& candidate : all) least = std::min(least, candidate.error());
  for (const Proposal& candidate : all)
    if (candidate.error() <= kDoubt * least) keep(plan.best, candidate, faster);
  return plan;
}

bool measured(const Proposal& proposal, const std::vector<Trial>& trials) {
  return std::any_of(trials.begin(), trials.end(), [&](const Trial& trial) {
    return trial.elements == proposal.elements && trial.integrator == proposal.integrator &&
           same_mesh(trial.refinement, proposal.refinement) && trial.substeps == proposal.substeps &&
           (trial.few == proposal.iterations || trial.many == proposal.iterations);
  });
}

}  // namespace fascia
