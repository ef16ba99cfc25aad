// Changes to which region the tets of an open scene belong, together with the materials of painted regions.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "sim/simulation/scene_edits.h"

namespace fascia {

/// "regions" of every body of a scene [bodies].
using RegionSets = std::vector<std::vector<TetRegion>>;

RegionSets painted_of(const Scene& scene);

struct Painting {
  RegionSets regions;
  std::vector<MaterialEntries> materials;  // [bodies]
  bool operator==(const Painting&) const = default;
};
Painting painting_of(const Scene& scene, const Model& model);

/// The current painting with these tets of the model in the region that has this key in "materials", or this new name;
/// an empty name gives them the region of the mesh file. A region that a body gets with it starts with the values of
/// `fresh`, over the body's default material. A painted region without tets goes, together with its material.
Painting with_painted(const Scene& scene, const Model& model, std::span<const std::uint32_t> tets,
                      const std::string& name, const MaterialOverride& fresh);

}  // namespace fascia
