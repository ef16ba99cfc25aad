#include "render/passes/look_defines.h"

#include "render/passes/shadow_map.h"

namespace fascia {

gl::Defines tissue_defines(const Look& look, const DrawnTriangles& drawn) {
  gl::Defines defines = backdrop_defines(look);
  const bool plain = !look.heat_map && !look.regions;
  const gl::Defines own{{"DEPTH_ONLY", "0"},
                        {"CAP", flag(drawn.cap)},
                        {"BASE_COLOR", flag(drawn.colored && plain)},
                        {"DETAIL", flag(drawn.detailed && plain && look.quality.detail)},
                        {"PAINTS", flag(drawn.paints && plain)},
                        {"HEAT_MAP", flag(look.heat_map)},
                        {"REGIONS", flag(look.regions)},
                        {"TRIANGLES", std::to_string(drawn.triangles)},
                        {"SHADOW", flag(look.shadow && !drawn.cap)},
                        {"CONTACT_SHADOW", flag(look.quality.contact_shadow)},
                        {"WIREFRAME", flag(look.wireframe)},
                        {"SECTION", flag(look.section.has_value())},
                        {"DEPTH_CUE", flag(look.depth_cue > 0)},
                        {"SHADOW_TAPS", std::to_string(look.quality.shadow_taps)}};
  defines.insert(defines.end(), own.begin(), own.end());
  const gl::Defines shadow = ShadowMap::defines();
  defines.insert(defines.end(), shadow.begin(), shadow.end());
  return defines;
}

gl::Defines depth_defines(const Look& look) {
  return {{"DEPTH_ONLY", "1"},
          {"BASE_COLOR", "0"},
          {"HEAT_MAP", "0"},
          {"DETAIL", "0"},
          {"SHADOW", "0"},
          {"WIREFRAME", "0"},
          {"SECTION", flag(look.section.has_value())}};
}

}  // namespace fascia
