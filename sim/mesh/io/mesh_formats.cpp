#include "sim/mesh/io/mesh_formats.h"

namespace fascia {
namespace {

template <class Condition>
std::vector<std::string> endings_if(Condition fits) {
  std::vector<std::string> endings;
  for (const MeshFormat& format : mesh_formats())
    if (fits(format)) endings.insert(endings.end(), format.endings.begin(), format.endings.end());
  return endings;
}

}  // namespace

const std::vector<MeshFormat>& mesh_formats() {
  using enum MeshFormat::Holds;
  using enum MeshFormat::Written;
  static const std::vector<MeshFormat> formats = {{"Gmsh", {".msh"}, both, ten_nodes},
                                                  {"VTK", {".vtk", ".vtu"}, both, ten_nodes},
                                                  {"TetGen", {".node", ".ele"}, tets, four_nodes},
                                                  {"Medit", {".mesh"}, both, four_nodes},
                                                  {"Abaqus", {".inp"}, both, ten_nodes},
                                                  {"FEBio", {".feb"}, both, no},
                                                  {"Vega", {".veg"}, tets, no},
                                                  {"Wavefront", {".obj"}, surfaces, no},
                                                  {"STL", {".stl"}, surfaces, no},
                                                  {"PLY", {".ply"}, surfaces, no},
                                                  {"OFF", {".off"}, surfaces, no},
                                                  {"VTK PolyData", {".vtp"}, surfaces, no}};
  return formats;
}

std::vector<std::string> tet_endings() {
  return endings_if([](const MeshFormat& format) { return format.holds != MeshFormat::Holds::surfaces; });
}
std::vector<std::string> surface_endings() {
  return endings_if([](const MeshFormat& format) { return format.holds == MeshFormat::Holds::surfaces; });
}
std::vector<std::string> written_endings() {
  return endings_if([](const MeshFormat& format) { return format.written != MeshFormat::Written::no; });
}
std::vector<std::string> ten_node_endings() {
  return endings_if([](const MeshFormat& format) { return format.written == MeshFormat::Written::ten_nodes; });
}

std::string listed_formats() {
  std::string text;
  for (const MeshFormat& format : mesh_formats()) {
    text += (text.empty() ? "" : ", ") + format.name;
    for (const std::string& ending : format.endings) text += " " + ending;
  }
  return text;
}

}  // namespace fascia
