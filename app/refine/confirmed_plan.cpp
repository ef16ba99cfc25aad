#include "app/refine/confirmed_plan.h"

#include <algorithm>

#include "base/interrupt.h"

namespace fascia {
namespace {

/// The coarsest mesh that is proposed where none can be made: of half as many tets. How wrong a coarser one is, whose
/// cells may be as large as parts of the body, the one at hand does not say.
constexpr double kCoarsestUnseen = 0.79;

/// The finest mesh that a choice for the error alone is run on.
double finest_run(const std::vector<double>& refinements, const std::vector<Trial>& trials) {
  double finest = 1;
  for (const double refinement : refinements)
    if (refinement < 1.001 * kFinestRun) finest = std::max(finest, refinement);
  for (const Trial& trial : trials) finest = std::max(finest, trial.refinement);
  return finest;
}

const Trial* alike(const Proposal& choice, const std::vector<Trial>& trials) {
  const auto found = std::find_if(trials.begin(), trials.end(), [&](const Trial& trial) {
    Proposal own = choice;
    own.iterations = trial.many;
    return measured(own, {trial});
  });
  return found == trials.end() ? nullptr : &*found;
}

bool is_same_run(const Proposal& a, const Proposal& b) {
  return a.elements == b.elements && a.integrator == b.integrator && a.refinement == b.refinement &&
         a.substeps == b.substeps && a.iterations == b.iterations;
}

}  // namespace

Plan confirmed_plan(std::vector<Trial>& trials, double error, double ms, Meshes meshes, const RunChoice& run) {
  // What is run for a choice.
  const auto trial_for = [&](Proposal choice) {
    if (!meshes.can_be_made)
      choice.refinement = 1;
    else if (choice.ms > ms)
      choice.refinement = std::min(choice.refinement, finest_run(meshes.refinements, trials));
    return choice;
  };
  const auto confirmed = [&](const Proposal& choice) { return measured(trial_for(choice), trials); };
  if (!meshes.can_be_made) std::erase_if(meshes.refinements, [](double r) { return r < kCoarsestUnseen; });
  std::vector<Proposal> done;
  const auto has_run = [&](const Proposal& choice) {
    return std::any_of(done.begin(), done.end(), [&](const Proposal& other) { return is_same_run(choice, other); });
  };
  const auto open_or_confirmed = [&](const Proposal& choice) {
    return confirmed(choice) || !has_run(trial_for(choice));
  };
  for (int runs = 0; runs < kMostRuns; ++runs) {
    const Plan plan = plan_for(trials, error, ms, meshes.refinements, open_or_confirmed);
    std::vector<std::optional<Proposal>> proposals{plan.exact, plan.fast};
    if (plan.within) proposals = {plan.within};
    const auto open = std::find_if(proposals.begin(), proposals.end(),
                                   [&](const auto& choice) { return choice && !confirmed(*choice); });
    if (open == proposals.end() || interrupted()) return plan;
    const Proposal choice = done.emplace_back(trial_for(**open));
    if (const std::optional<Trial> trial = run(choice, alike(choice, trials)))
      trials.push_back(*trial);
    else
      std::erase(meshes.refinements, choice.refinement);
  }
  Plan plan = plan_for(trials, error, ms, meshes.refinements, confirmed);
  plan.cut_off = true;
  return plan;
}

}  // namespace fascia
