// Closed surfaces of the kinds that users fill with tets: solids, organs, vessels, plates, shells, and shapes with
// sharp edges.
#pragma once
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

}  // namespace fascia
