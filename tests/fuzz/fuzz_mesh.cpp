// A mesh of any format through the whole program: format detection, the mesh check, every writer, and each written file
// read again.
#include <sstream>

#include "base/error.h"
#include "sim/mesh/io/formats.h"
#include "sim/mesh/mesh_check.h"
#include "tests/fuzz/fuzz.h"

using namespace fascia;

namespace {

void check_copy(const MeshFile& original, const MeshFile& copy) {
  fuzz::check_mesh(copy.mesh);
  fuzz::require(copy.mesh.tets == original.mesh.tets, "a written mesh has the same tets");
  fuzz::require(copy.mesh.regions == original.mesh.regions, "a written mesh has the same regions");
  fuzz::require(copy.mesh.positions == original.mesh.positions, "a written mesh has the same positions");
}

/// Gmsh files cannot store every name and number; the writer then throws an Error.
template <class Write>
void check_gmsh(const MeshFile& file, Write write) {
  std::string text;
  try {
    text = write("fuzz.msh", file.mesh);
  } catch (const Error&) {
    return;
  }
  check_copy(file, read_mesh_content("fuzz.msh", text));
}

}  // namespace

FUZZ_TARGET(mesh) {
  const MeshFile file = read_mesh_content("fuzz.msh", data, [&](const std::string&) { return std::string(data); });
  fuzz::check_file(file);
  if (file.is_surface()) return;
  std::ostringstream report;
  const MeshRepair repaired = repair(file.mesh);
  print_report(report, file, repaired, examine(file.mesh, repaired));

  check_copy(file, read_mesh_content("fuzz.vtk", vtk_legacy_text(file.mesh)));
  check_copy(file, read_mesh_content("fuzz.vtu", vtu_text(file.mesh)));
  check_copy(file, read_mesh_content("fuzz.mesh", medit_text(file.mesh)));
  check_gmsh(file, gmsh22_text);
  check_gmsh(file, gmsh41_text);
  MeshFile copy;
  read_tetgen_content("fuzz.node", tetgen_node_text(file.mesh), "fuzz.ele", tetgen_ele_text(file.mesh), copy);
  check_copy(file, copy);
}
