// Shared by the tests of the mesh check: meshes of a few tets, and their reports.
#pragma once
#include <sstream>

#include "sim/mesh/mesh_check.h"

namespace fascia::test {

using Indices = std::vector<std::uint32_t>;

inline TetMesh make_mesh(std::vector<Eigen::Vector3d> positions, std::vector<Tet> tets) {
  TetMesh mesh;
  mesh.regions.assign(tets.size(), 0);
  mesh.positions = std::move(positions);
  mesh.tets = std::move(tets);
  return mesh;
}

inline MeshReport examined(const TetMesh& mesh) { return examine(mesh, repair(mesh)); }

inline std::string report_text(const TetMesh& mesh) {
  MeshFile file;
  file.mesh = mesh;
  file.format = "test";
  const MeshRepair repaired = repair(mesh);
  std::ostringstream out;
  print_report(out, file, repaired, examine(mesh, repaired));
  return out.str();
}

}  // namespace fascia::test
