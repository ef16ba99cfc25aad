// The regions of a body's mesh, as its file or the scene has them, and their materials.
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
  std::map<int, std::uint32_t> of_region;  // regions without the default material: index into materials

  std::uint32_t material_of(int region) const {
    const auto it = of_region.find(region);
    return it == of_region.end() ? 0 : it->second;
  }
};

/// `material` with the given values replaced.
Material with_override(Material material, const MaterialOverride& values);
MaterialOverride override_with(const Material& material);  // all values given

/// The regions of a mesh's tets: number, and name if the file has one.
std::map<int, std::string> regions_of(const TetMesh& mesh);

/// Gives the tets of Body::regions their region. A name that the mesh does not have becomes a new number: itself if it
/// is one, else the smallest that is free here and in the names `taken` by other bodies. Throws Error for a tet that
/// the mesh does not have, and for one in two regions.
void assign_regions(const Body& body, const std::map<int, std::string>& taken, const std::string& where, TetMesh& mesh);

/// Throws Error for a key that is neither a name nor a number of a region, and for two keys of one region.
BodyMaterials resolve_materials(const Body& body, const std::map<int, std::string>& regions, const std::string& where);

/// Assigns materials, names and each tet's material again from the scene's bodies, after entries of "materials" were
/// added or removed: the result equals build_model(scene). Throws Error as resolve_materials does, and leaves the model
/// unchanged.
void assign_materials(const Scene& scene, Model& model);

/// The key of a region in a scene's "materials": its name if no other region has it, else its number.
std::string key_of_region(const std::map<int, std::string>& regions, int number);

}  // namespace fascia
