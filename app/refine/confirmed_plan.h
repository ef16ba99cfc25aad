// A plan whose proposals have been run: what a mesh does to contact, to vibrations and to the solver does not follow
// from another mesh.
#pragma once
#include <functional>
#include <optional>
#include <vector>

#include "app/refine/plan.h"

namespace fascia {

struct Meshes {
  std::vector<double> refinements = usual_refinements();
  bool can_be_made = false;  // false: trials have the mesh at hand only
};

/// Runs a choice. `alike`: a trial that differs in its iterations only, or null. None: the choice cannot be run.
using RunChoice = std::function<std::optional<Trial>(const Proposal& choice, const Trial* alike)>;

/// Adds trials of what the plan for the first ones proposes, until every proposal is one of them: the choice within
/// error and time, or else both of the others. A choice for the error alone may take any time: where its mesh is finer
/// than kFinestRun and than those of all trials, the finest one that is not is run with its other choices, and the
/// proposal follows from that. No choice is run twice. Meshes that cannot be made are replaced by the one at hand in
/// the same way. After kMostRuns it is the plan of what was run. Ends early when interrupted() becomes true. Throws
/// what `run` throws.
Plan confirmed_plan(std::vector<Trial>& trials, double error, double ms, Meshes meshes, const RunChoice& run);
constexpr double kFinestRun = 2;  // refinement: eight times the tets of the mesh at hand
constexpr int kMostRuns = 16;

}  // namespace fascia
