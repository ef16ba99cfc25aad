#include "app/refine/plan_text.h"

#include <algorithm>
#include <cmath>

#include "app/refine/choice.h"
#include "app/refine/confirmed_plan.h"
#include "base/text.h"

namespace fascia {
namespace {

std::string percent(double share) { return number(100 * share) + " %"; }

std::string choices(const Proposal& p) {
  return std::to_string(std::lround(p.tets)) + ' ' + name_of(p.elements) + " tets (edges " +
         (p.refinement == 1 ? "as they are" : number(1 / p.refinement) + " times as long") + "), " +
         name_of(p.integrator) + ", " + plural(static_cast<std::size_t>(p.substeps), "substep") + ", " +
         plural(static_cast<std::size_t>(p.iterations), "iteration");
}

std::string errors(const Proposal& p) {
  return percent(p.error()) + ": " + (p.shape > 0 ? "shape " + percent(p.shape) + ", " : "") + "mesh " +
         percent(p.mesh) + ", time " + percent(p.time) + ", solver " + percent(p.solver);
}

std::string describe(const Proposal& p, const Scene& scene) {
  std::string text = "  " + choices(p) + "\n  error " + errors(p) + "; " + number(p.ms) + " ms a step\n ";
  for (const std::string& set : sets_of(p, scene)) text += " --set " + set;
  if (p.other_mesh) {
    if (!has_resolution(scene)) text += "\n  and a mesh with that many tets";
    text += "\n  extrapolated from a mesh of " + plural(p.from_tets, "tet") + ": no run had this one";
  }
  return text + '\n';
}

/// The largest part of an error, in words.
std::string most_of(const Proposal& p) {
  const double largest = std::max({p.shape, p.mesh, p.time, p.solver});
  return largest == p.time ? "time" : largest == p.mesh ? "the mesh" : largest == p.shape ? "the shape" : "the solver";
}

std::string extrapolated(const Proposal& p) { return p.measured ? "" : ", extrapolated"; }

std::string no_accurate_choice(const Plan& plan, const Wanted& wanted) {
  const Proposal& p = *plan.best;
  std::string text = "for the error: no choice; the least error found is " + errors(p) + "; most of it in " +
                     most_of(p) + "; with " + choices(p) + ", " + number(p.ms) + " ms a step" + extrapolated(p) + "; ";
  if (plan.cut_off) return text + "the search ends after " + std::to_string(kMostRuns) + " runs\n";
  return text + "the search ends at " + std::to_string(kMostSubsteps) + " substeps, " +
         std::to_string(kMostIterations) + " iterations and " + number(wanted.most_tets) + " times the tets\n";
}

std::string no_fast_choice(const Plan& plan) {
  const Proposal& p = *plan.fastest;
  return "for the time: no choice; the fastest takes " + number(p.ms) + " ms a step" + extrapolated(p) + ", with " +
         choices(p) + " and an error of " + percent(p.error()) + "\n";
}

}  // namespace

std::string plan_text(const Plan& plan, const Scene& scene, const Wanted& wanted) {
  const std::string both = percent(wanted.error) + " in " + number(wanted.ms) + " ms";
  if (plan.within) return "for " + both + " a step:\n" + describe(*plan.within, scene);
  std::string text = "not within reach: " + both + " a step\n";
  if (!plan.best || !plan.fastest) return text + "no choice could be run\n";
  text += plan.exact ? "for the error:\n" + describe(*plan.exact, scene) : no_accurate_choice(plan, wanted);
  return text + (plan.fast ? "for the time:\n" + describe(*plan.fast, scene) : no_fast_choice(plan));
}

}  // namespace fascia
