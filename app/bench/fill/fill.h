// fascia bench fill: how well tets fill closed surfaces. Needs no graphics.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/bench/fill/shapes.h"
#include "app/bench/table.h"

namespace fascia {

/// The quality of a filled surface.
struct FillQuality {
  int resolution = 0;
  std::size_t tets = 0;
  double smallest_dihedral_deg = 0, largest_dihedral_deg = 0;
  double volume_error = 0;  // of the tets against the surface, relative
  double distance = 0;      // Hausdorff distance of the boundary of the tets and the surface, over the longest side
  double spacings = 0;      // the same over the spacing of the lattice
  std::vector<std::string> notes;
};

/// Throws Error for a surface that cannot be filled.
FillQuality fill_quality(const Shape& shape, std::optional<int> resolution);

/// All shapes at the default resolution and at twice that; with `quick` at a coarse one.
Table fill_table(bool quick);

}  // namespace fascia
