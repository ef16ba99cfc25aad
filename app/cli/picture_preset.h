// Presets of pictures (option --preset of render): scene values and samples for a purpose, under those of the command
// line.
#pragma once
#include <optional>
#include <string>
#include <vector>

namespace fascia {

struct PicturePreset {
  const char* name;
  const char* help;
  std::vector<std::string> sets;  // as texts of --set
  int samples;                    // per pixel
};
const std::vector<PicturePreset>& picture_presets();

/// The texts of --set of a preset; none without a name.
std::vector<std::string> preset_sets(const std::string& name);

}  // namespace fascia
