// Instruments to add to an open scene, as large as its bodies ask for.
#pragma once
#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "sim/scene/tools/scene_tools.h"
#include "sim/simulation/simulation.h"

namespace fascia {

enum class InstrumentPreset { sphere, probe, paddle, forceps };
struct InstrumentPresetInfo {
  InstrumentPreset preset;
  const char* name;  // in scenes
  const char *label, *help;
};
inline constexpr std::array<InstrumentPresetInfo, 4> kInstrumentPresets = {
    {{InstrumentPreset::sphere, "sphere", "Sphere", "A ball that presses"},
     {InstrumentPreset::probe, "probe", "Probe", "A thin rod with a round tip, for palpation"},
     {InstrumentPreset::paddle, "paddle", "Paddle", "A flat plate with rounded edges, to hold tissue aside"},
     {InstrumentPreset::forceps, "forceps", "Forceps",
      "Two jaws that close on tissue (hold G) and keep it by friction"}}};

/// Above the bodies where they are and where the scene begins, so that it is in none of them after a reset either.
Instrument preset_instrument(InstrumentPreset preset, const Simulation& simulation);
/// Above the middle of the bodies, which `bodies` contains [m]. Its name is none of `taken`: "probe", "probe 2", ...
Instrument preset_instrument(InstrumentPreset preset, const Eigen::AlignedBox3d& bodies,
                             const std::vector<std::string>& taken);

}  // namespace fascia
