// Which material each region of a body's mesh has.
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "sim/scene.h"
#include "sim/tet_mesh.h"

namespace fascia {

struct BodyMaterials {
  std::vector<Material> materials;  // the default, then one per entry of Body::region_materials, in its order
  std::vector<std::string> names;   // "beam: default", "beam: 2"
  std::map<int, std::uint32_t> of_region;  // regions that do not have the default: index into materials

  std::uint32_t material_of(int region) const {
    const auto it = of_region.find(region);
    return it == of_region.end() ? 0 : it->second;
  }
};

/// Throws Error for a key that is neither a name nor a number of a region, and for two keys of one region.
BodyMaterials resolve_materials(const Body& body, const TetMesh& mesh, const std::string& where);

}  // namespace fascia
