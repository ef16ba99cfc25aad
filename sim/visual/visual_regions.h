// The regions of a scene's meshes for pictures: one number for every tet and for every triangle of the drawn surface.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "sim/visual/visual_surface.h"

namespace fascia {

struct VisualRegions {
  std::vector<std::string> names;          // "tumour", "region 2"; with several bodies "liver: tumour"
  std::vector<std::uint32_t> first_tet;    // [names] one of its tets, in Model::tets
  std::vector<Tet> tets;                   // of pictures (sim/mesh/linear_tets.h)
  std::vector<std::uint32_t> of_tet;       // [tets] index into names
  std::vector<std::uint32_t> of_triangle;  // [VisualSurface::triangles]
};

/// Each combination of body and region number is a region, in ascending order of both. A triangle of an embedded
/// surface takes the region of the tet in which its first vertex is embedded.
VisualRegions drawn_regions(const Scene& scene, const Model& model, const VisualSurface& surface);

}  // namespace fascia
