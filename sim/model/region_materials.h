// Which material each region of a body's mesh has.
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "sim/model/model.h"

namespace fascia {

struct BodyMaterials {
  std::vector<Material> materials;         // the default, then one per entry of Body::region_materials, in its order
  std::vector<std::string> names;          // "beam: default", "beam: 2"
  std::map<int, std::uint32_t> of_region;  // regions that do not have the default: index into materials

  std::uint32_t material_of(int region) const {
    const auto it = of_region.find(region);
    return it == of_region.end() ? 0 : it->second;
  }
};

/// `material` with the values that are given.
Material with_override(Material material, const MaterialOverride& values);

/// The regions that a mesh's tets have: number, and name if the file has one.
std::map<int, std::string> regions_of(const TetMesh& mesh);

/// Throws Error for a key that is neither a name nor a number of a region, and for two keys of one region.
BodyMaterials resolve_materials(const Body& body, const std::map<int, std::string>& regions, const std::string& where);

/// Materials, names and which tet has which, anew from the scene's bodies, after entries of "materials" came or went:
/// the model is as build_model(scene) makes it. Throws Error as resolve_materials does, and leaves the model as it was.
void assign_materials(const Scene& scene, Model& model);

/// The key that a scene's "materials" calls a region by: its name where that is its own and no other region's, else its
/// number.
std::string key_of_region(const std::map<int, std::string>& regions, int number);

}  // namespace fascia
