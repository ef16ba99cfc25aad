// The brush of the mouse: what it does, its shape, and what it paints.
#pragma once
#include <string>

#include "sim/material/tissue_looks.h"
#include "sim/material/tissues.h"
#include "sim/scene/scene.h"

namespace fascia {

/// Fixes or releases vertices, paints tets into a region, or gives them the region of the mesh file again.
enum class Brush { off, fix, release, paint, erase };

struct BrushSettings {
  Brush brush = Brush::off;
  bool lasso = false;    // a closed curve, instead of a ring that is dragged
  bool through = false;  // a lasso takes all tets below it, at any depth
  double depth = 0.1;    // else those so little behind the visible tissue [scene radii]
  std::string region;    // key of the region that is painted; empty: a new one
  std::string new_name = "painted";
  const Tissue* tissue = find_tissue("breast_tumor");  // of a new region; null: as the tissue around it

  bool reveal = false;  // the panel scrolls to its rows

  bool in_hand() const { return brush != Brush::off; }
  bool of_tets() const { return brush == Brush::paint || brush == Brush::erase; }
  const std::string& painted_region() const { return region.empty() ? new_name : region; }
  /// Of a new region: the values of the tissue, with the law and the damping of the body.
  MaterialOverride fresh_material() const {
    MaterialOverride values;
    if (!tissue) return values;
    values.young_modulus = tissue->young_modulus;
    values.poisson_ratio = tissue->poisson_ratio;
    values.density = tissue->density;
    values.look = find_look(tissue->look);
    return values;
  }
};

}  // namespace fascia
