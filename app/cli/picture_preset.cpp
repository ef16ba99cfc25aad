#include "app/cli/picture_preset.h"

#include <algorithm>

namespace fascia {

const std::vector<PicturePreset>& picture_presets() {
  static const std::vector<PicturePreset> presets{
      {"paper",
       "for print: white background, no marks, a large legend without a plate",
       {"display.background=white", "display.ground=false", "display.marks=false", "display.legend.side=right",
        "display.legend.font_size=22", "display.legend.plate=false", "display.ambient_occlusion=0.5"},
       64}};
  return presets;
}

std::vector<std::string> preset_sets(const std::string& name) {
  const auto& presets = picture_presets();
  const auto found =
      std::find_if(presets.begin(), presets.end(), [&](const PicturePreset& p) { return p.name == name; });
  return found == presets.end() ? std::vector<std::string>() : found->sets;
}

}  // namespace fascia
