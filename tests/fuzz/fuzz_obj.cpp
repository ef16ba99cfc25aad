// Wavefront .obj surfaces: read, drawn and filled with tets.
#include "sim/surface/surface_fill.h"
#include "tests/fuzz/fuzz.h"

using namespace fascia;

FUZZ_TARGET(obj) {
  const auto library = [&](const std::string& name) {
    return name == "a.mtl" ? "newmtl red\nKd 0.8 0.1 0.1\n" : std::string(data);
  };
  SurfaceMesh surface = read_obj_content("fuzz.obj", data, library);
  for (const Eigen::Vector3d& x : surface.positions) fuzz::require(x.allFinite(), "positions are finite");
  for (const Triangle& triangle : surface.triangles) {
    for (const std::uint32_t v : triangle)
      fuzz::require(v < surface.positions.size(), "triangles name vertices of the surface");
  }
  fuzz::require(surface.colors.empty() || surface.colors.size() == 3 * surface.triangles.size(),
                "all corners have a color or none");
  const FilledSurface filled = fill_surface(std::move(surface), "fuzz.obj", 4);
  const TetMesh& mesh = filled.file.mesh;
  for (const Eigen::Vector3d& x : mesh.positions) fuzz::require(x.allFinite(), "positions of tets are finite");
  for (const Tet& tet : mesh.tets) {
    for (const std::uint32_t v : tet) fuzz::require(v < mesh.positions.size(), "tets name vertices");
  }
}
