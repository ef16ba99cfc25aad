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
  static const std::vector<MeshFormat> formats = {{"Gmsh", {".msh"}, both, true},
                                                  {"VTK", {".vtk", ".vtu"}, both, true},
                                                  {"TetGen", {".node", ".ele"}, tets, true},
                                                  {"Medit", {".mesh"}, both, true},
                                                  {"Abaqus", {".inp"}, both, true},
                                                  {"FEBio", {".feb"}, both, false},
                                                  {"Vega", {".veg"}, tets, false},
                                                  {"Wavefront", {".obj"}, surfaces, false},
                                                  {"STL", {".stl"}, surfaces, false},
                                                  {"PLY", {".ply"}, surfaces, false},
                                                  {"OFF", {".off"}, surfaces, false},
                                                  {"VTK PolyData", {".vtp"}, surfaces, false}};
  return formats;
}

std::vector<std::string> tet_endings() {
  return endings_if([](const MeshFormat& format) { return format.holds != MeshFormat::Holds::surfaces; });
}
std::vector<std::string> surface_endings() {
  return endings_if([](const MeshFormat& format) { return format.holds == MeshFormat::Holds::surfaces; });
}
std::vector<std::string> written_endings() {
  return endings_if([](const MeshFormat& format) { return format.written; });
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
