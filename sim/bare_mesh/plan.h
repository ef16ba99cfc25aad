// Guesses what a mesh file does not state, for a mesh that is opened on its own: the unit of length, the axis that
// points up, supports with which it stands or hangs, and a stiffness that its weight strains by some percent. A
// function of the mesh alone, with a reason for each choice.
#pragma once
#include <filesystem>

#include "sim/mesh/tet_mesh.h"
#include "sim/model/bare_mesh_plan.h"

namespace fascia {

/// `file`: its ending hints at the axis. `tets`: the usable ones. `body`: its values that `open` does not leave open
/// are kept, and the others follow from them. `gravity` [m/s^2] is its magnitude; without gravity that of the Earth is
/// assumed. `extent`: the largest one of the surface that the tets fill and may stick out of, in the file's unit; 0
/// without one.
BareMeshPlan plan_bare_mesh(const std::filesystem::path& file, const TetMesh& mesh, const std::vector<Tet>& tets,
                            const Unsettled& open, const Body& body, double gravity, double extent = 0);

/// The unit in which a body of this largest extent has the size of tissue.
LengthUnit likely_unit(double extent);

/// One line: "torso.vtk: mm (480 mm wide), z up (...), ...".
std::string text_of(const BareMeshPlan& plan);

}  // namespace fascia
