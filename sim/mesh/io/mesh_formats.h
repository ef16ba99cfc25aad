// The file formats that fascia reads, one row each: dialogs, help and messages are made from it.
#pragma once
#include <string>
#include <vector>

namespace fascia {

struct MeshFormat {
  std::string name;                  // as in messages
  std::vector<std::string> endings;  // lower case, with the dot
  enum class Holds { tets, surfaces, both } holds;
  enum class Written { no, four_nodes, ten_nodes } written;  // by write_mesh(): how many nodes of a quadratic tet
};
const std::vector<MeshFormat>& mesh_formats();

/// The endings of formats that hold tets, and of those that hold surfaces only.
std::vector<std::string> tet_endings();
std::vector<std::string> surface_endings();

std::vector<std::string> written_endings();
/// Those of formats that are written with all nodes of quadratic tets.
std::vector<std::string> ten_node_endings();

/// "Gmsh .msh, VTK .vtk .vtu, ...".
std::string listed_formats();

}  // namespace fascia
