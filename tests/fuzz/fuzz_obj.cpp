// Wavefront .obj surfaces.
#include "sim/surface_mesh.h"
#include "tests/fuzz/fuzz.h"

using namespace fascia;

FUZZ_TARGET(obj) {
  const SurfaceMesh surface = read_obj_content("fuzz.obj", data);
  for (const Eigen::Vector3d& x : surface.positions) fuzz::require(x.allFinite(), "positions are finite");
  for (const Triangle& triangle : surface.triangles) {
    for (const std::uint32_t v : triangle) fuzz::require(v < surface.positions.size(), "triangles name vertices of the surface");
  }
}
