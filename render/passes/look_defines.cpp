#include "render/passes/look_defines.h"

#include "render/passes/shadow_map.h"

namespace fascia {

gl::Defines tissue_defines(const Look& look, bool cap, int triangles, bool colored) {
  gl::Defines defines = backdrop_defines(look);
  const gl::Defines own{{"DEPTH_ONLY", "0"},
                        {"CAP", flag(cap)},
                        {"BASE_COLOR", flag(colored)},
                        {"HEAT_MAP", flag(look.heat_map)},
                        {"REGIONS", flag(look.regions)},
                        {"TRIANGLES", std::to_string(triangles)},
                        {"SHADOW", flag(look.shadow && !cap)},
                        {"WIREFRAME", flag(look.wireframe)},
                        {"SECTION", flag(look.section.has_value())},
                        {"DEPTH_CUE", flag(look.depth_cue > 0)},
                        {"SHADOW_TAPS", "5"},
                        {"SHADOW_SIZE", std::to_string(ShadowMap::kSize) + ".0"}};
  defines.insert(defines.end(), own.begin(), own.end());
  return defines;
}

gl::Defines depth_defines(const Look& look) {
  return {{"DEPTH_ONLY", "1"}, {"BASE_COLOR", "0"}, {"HEAT_MAP", "0"},
          {"SHADOW", "0"},     {"WIREFRAME", "0"},  {"SECTION", flag(look.section.has_value())}};
}

}  // namespace fascia
