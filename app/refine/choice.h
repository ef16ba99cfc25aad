// A proposal as the --set options that make it of a scene, and the meshes that a scene can have.
#pragma once
#include <string>
#include <vector>

#include "app/refine/plan.h"

namespace fascia {

/// Whether a body is a surface filled with as many cells as the scene says (`resolution`). Other meshes stay.
bool has_resolution(const Scene& scene);
/// Those of usual_refinements() that are whole numbers of cells in the first body with a resolution; the usual ones in
/// a scene without.
std::vector<double> refinements_of(const Scene& scene);

/// "KEY=VALUE" each, for the elements and the resolution of every body and for the solver.
std::vector<std::string> sets_of(const Proposal& proposal, const Scene& scene);

}  // namespace fascia
