// Looks of tissues in pictures, in one table: the scene key materials.*.look, which a preset sets, too. A look has
// colors and the amounts of a few surface effects; none of them influences the simulation.
#pragma once
#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace fascia {

using SrgbColor = std::array<float, 3>;  // 0 to 1

struct TissueLook {
  const char* name;   // "liver", as in scene files
  const char* label;  // as displayed: "Liver"
  SrgbColor color;
  SrgbColor patches;  // color of its darker or paler patches
  SrgbColor lines;    // color of the vessels, fat or septa in its surface
  float patch_size;   // of the largest patches, as a share of the scene's radius at rest
  float patchiness;   // 0 (one color) to 1
  float line_share;   // of the surface that lines cover, 0 (none) to 1
  float stretch;      // of patches and bumps along the body's longest side: 1 (none) to 8 (fibers)
  float bumpiness;    // slope of the fine bumps [-]
  float wetness;      // strength of highlights and reflections, 0 (matte) to 1 (wet)
  float scattering;   // how far light passes the shadow's border, 0 (bone) to 1 (fat)
};

const std::vector<TissueLook>& tissue_looks();       // the first one is that of materials without a look
const TissueLook* find_look(std::string_view name);  // null if there is no such look
std::vector<std::string> look_names();

}  // namespace fascia
