// A model as an input file of Abaqus or CalculiX, to be completed by a step.
#pragma once
#include <string>

#include "sim/model/model.h"
#include "sim/model/state.h"

namespace fascia {

/// SI units. Nodes at the positions of the state; the usable tets with one set, *SOLID SECTION and *MATERIAL (small
/// strain: E, nu; density) per material, which with NLGEOM is St. Venant-Kirchhoff's law; the groups of the meshes; the
/// set `fixed`, held by *BOUNDARY, and a set per prescribed motion.
std::string abaqus_model_text(const Model& model, const State& state);

}  // namespace fascia
