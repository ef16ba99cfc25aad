// Surfaces of all formats: recognized, divided into triangles and filled with tets.
#include "sim/surface/shape_file.h"
#include "sim/surface/surface_fill.h"
#include "tests/fuzz/fuzz.h"

using namespace fascia;

FUZZ_TARGET(shape) {
  ShapeFile shape = read_shape_content("fuzz.msh", data, [&](const std::string&) { return std::string(data); });
  if (!shape.surface) return fuzz::check_file(shape.tets);
  const SurfaceMesh& surface = *shape.surface;
  for (const Triangle& triangle : surface.triangles) {
    for (const std::uint32_t v : triangle)
      fuzz::require(v < surface.positions.size(), "triangles name vertices of the surface");
  }
  fuzz::require(surface.colors.empty() || surface.colors.size() == 3 * surface.triangles.size(),
                "all corners have a color or none");
  fuzz::check_mesh(fill_surface(std::move(*shape.surface), "fuzz.msh", 4).file.mesh);
}
