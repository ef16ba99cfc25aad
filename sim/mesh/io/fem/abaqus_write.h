// Writing Abaqus and CalculiX .inp.
#pragma once
#include <map>
#include <string>

#include "sim/mesh/tet_mesh.h"

namespace fascia {

/// The nodes, elements and sets of a mesh as text, and the names of the sets in it, which hold letters, digits,
/// underscores and hyphens alone.
struct AbaqusMesh {
  std::string text;
  std::map<int, std::string> regions;         // sets of elements; region 0 without a name has none
  std::map<std::string, std::string> groups;  // sets of nodes by the names of TetMesh::groups
};

/// Tets are C3D4 and C3D10. Numbers begin at 1, in the order of the mesh. Coordinates that need more than the 20
/// characters that CalculiX reads have 13 digits. Groups that only repeat a region are left out.
AbaqusMesh abaqus_mesh(const TetMesh& mesh);

}  // namespace fascia
