// Closed surfaces of the kinds that users fill with tets: solids, organs, vessels, plates, shells, and shapes with
// sharp edges.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "sim/surface/surface_mesh.h"

namespace fascia {

struct Shape {
  std::string name;
  SurfaceMesh surface;
};

/// Twenty of them, each about 0.2 m wide.
std::vector<Shape> fill_shapes();

/// As a .obj file.
void write_shape(const std::filesystem::path& path, const SurfaceMesh& surface);

}  // namespace fascia
