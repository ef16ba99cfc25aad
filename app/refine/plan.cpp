#include "app/refine/plan.h"

#include <algorithm>
#include <cmath>

#include "sim/accuracy/time_extrapolation.h"

namespace fascia {
namespace {

// Steps by which the number of tets doubles; beyond these a measured mesh says little.
constexpr int kCoarsest = -4, kFinest = 9;
constexpr int kSubsteps[] = {1, 2, 4, 8};
constexpr int kIterations[] = {3, 5, 7, 10, 15, 20, 30};
// A measured step may be unusually good; more iterations than measured are not trusted with more than this.
constexpr double kBestRate = 0.6;  // of the error, per iteration
constexpr double kRounding = 1e-6;
// What a substep takes beside its iterations is measured as a difference of times, which scatter: at most this.
constexpr double kMostBeside = 0.5;  // of the time with `many` iterations

bool of_one_kind(const Trial& a, const Trial& b) { return a.elements == b.elements && a.integrator == b.integrator; }

/// Whether another trial says more about so many substeps.
bool superseded(const Trial& trial, int substeps, const std::vector<Trial>& trials) {
  const auto nearer = [&](const Trial& other) {
    if (!of_one_kind(trial, other)) return false;
    if (trial.substeps > substeps) return other.substeps < trial.substeps;
    return other.substeps <= substeps && other.substeps > trial.substeps;
  };
  return std::any_of(trials.begin(), trials.end(), nearer);
}

}  // namespace

double Trial::ns_per_tet_iteration() const {
  const double all = ms_many / many, slope = (ms_many - ms_few) / (many - few);
  return 1e6 * std::clamp(slope, (1 - kMostBeside) * all, all) / (static_cast<double>(tets) * substeps);
}

Proposal predicted(const Trial& trial, double refinement, int substeps, int iterations) {
  Proposal result{trial.elements, trial.integrator, refinement, 0, substeps, iterations};
  result.tets = static_cast<double>(trial.tets) * std::pow(refinement, 3);
  result.mesh = trial.mesh / (refinement * refinement);
  result.time = trial.time * std::pow(static_cast<double>(trial.substeps) / substeps,
                                      std::max(trial.order, TimeExtrapolation::kLeastOrder));
  const double few = std::max(trial.solver_few, kRounding), many = std::max(trial.solver_many, kRounding);
  const double rate = std::clamp(std::pow(many / few, 1.0 / (trial.many - trial.few)), kBestRate, 1.0);
  result.solver = std::max(kRounding, iterations > trial.many ? many * std::pow(rate, iterations - trial.many)
                                                              : few * std::pow(rate, iterations - trial.few));
  const double of_tet = 1e6 * trial.ms_many / (static_cast<double>(trial.tets) * trial.substeps);
  const double ns = of_tet + trial.ns_per_tet_iteration() * (iterations - trial.many);
  result.ms = 1e-6 * ns * result.tets * substeps;
  return result;
}

Plan plan_for(const std::vector<Trial>& trials, double error, double ms) {
  Plan plan;
  const auto faster = [](const Proposal& a, const Proposal& b) { return a.ms < b.ms; };
  const auto better = [](const Proposal& a, const Proposal& b) { return a.error() < b.error(); };
  const auto keep = [](std::optional<Proposal>& best, const Proposal& candidate, const auto& before) {
    if (!best || before(candidate, *best)) best = candidate;
  };
  for (const Trial& trial : trials)
    for (int doublings = kCoarsest; doublings <= kFinest; ++doublings)
      for (const int substeps : kSubsteps) {
        if (superseded(trial, substeps, trials)) continue;
        for (const int iterations : kIterations) {
          const Proposal candidate = predicted(trial, std::cbrt(std::pow(2.0, doublings)), substeps, iterations);
          if (!std::isfinite(candidate.error())) continue;
          if (candidate.error() <= error && candidate.ms <= ms) keep(plan.within, candidate, faster);
          if (candidate.error() <= error) keep(plan.exact, candidate, faster);
          if (candidate.ms <= ms) keep(plan.fast, candidate, better);
        }
      }
  return plan;
}

bool measured(const Proposal& proposal, const std::vector<Trial>& trials) {
  return std::any_of(trials.begin(), trials.end(), [&](const Trial& trial) {
    return trial.elements == proposal.elements && trial.integrator == proposal.integrator &&
           trial.substeps == proposal.substeps;
  });
}

}  // namespace fascia
