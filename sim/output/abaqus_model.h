// A model as an input file of Abaqus or CalculiX, to be completed by a step.
#pragma once
#include <string>

#include "sim/model/model.h"

namespace fascia {

/// SI units. Nodes displaced by `displacement` [vertices of the file] [m]; the usable tets with one set, *SOLID SECTION
/// and *MATERIAL (small strain: E, nu; density) per material, which with NLGEOM is St. Venant-Kirchhoff's law; the
/// groups of the meshes; the set `fixed`, held by *BOUNDARY, and a set per prescribed motion.
std::string abaqus_model_text(const Model& model, const std::vector<Eigen::Vector3d>& displacement);

}  // namespace fascia
