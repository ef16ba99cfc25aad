#include "app/state/instrument_presets.h"

#include <algorithm>

namespace fascia {
namespace {

constexpr double kForcepsFriction = 0.8;
constexpr double kOpen = 40;  // [degrees] between the jaws

std::string free_name(const std::string& wanted, const std::vector<std::string>& taken) {
  std::string name = wanted;
  for (int number = 2; std::find(taken.begin(), taken.end(), name) != taken.end(); ++number)
    name = wanted + " " + std::to_string(number);
  return name;
}

}  // namespace

Instrument preset_instrument(InstrumentPreset preset, const Eigen::AlignedBox3d& bodies,
                             const std::vector<std::string>& taken) {
  const double size = bodies.diagonal().norm(), thin = 0.03 * size, length = 0.5 * size;
  Instrument instrument;
  instrument.name = free_name(kInstrumentPresets[static_cast<std::size_t>(preset)].name, taken);
  double above = 0;  // of the origin over the lowest point
  switch (preset) {
    case InstrumentPreset::sphere:
      instrument.shape = ToolShape(SphereShape{{0, 0, 0}, 2 * thin});
      above = 2 * thin;
      break;
    case InstrumentPreset::probe:
      instrument.shape = ToolShape(CapsuleShape{{0, thin, 0}, {0, length, 0}, thin});
      break;
    case InstrumentPreset::paddle:
      instrument.shape = ToolShape(BoxShape{{0, 0.5 * length, 0}, {3 * thin, 0.5 * length, 0.7 * thin}, 0.5 * thin});
      break;
    case InstrumentPreset::forceps: {
      // The hinge is at the top, and the jaws point down; closed they touch.
      const BoxShape jaw{{0.8 * thin, -0.5 * length, 0}, {0.8 * thin, 0.5 * length, 1.5 * thin}, 0.5 * thin};
      instrument.shape = JawsShape{jaw, {0, 0, 1}, kOpen};
      instrument.friction = kForcepsFriction;
      above = length;
      break;
    }
  }
  const Eigen::Vector3d middle = bodies.center();
  instrument.path.push_back({0, {middle.x(), bodies.max().y() + above + 2 * thin, middle.z()}, {0, 0, 0}, 0});
  return instrument;
}

Instrument preset_instrument(InstrumentPreset preset, const Simulation& simulation) {
  const Model& model = simulation.model;
  Eigen::AlignedBox3d bodies;
  const std::vector<Eigen::Vector3d> displacement = simulation.state().displacement;
  for (std::size_t v = 0; v < displacement.size(); ++v)
    bodies.extend(model.rest_positions[v]).extend(model.rest_positions[v] + displacement[v]);
  std::vector<std::string> taken;
  for (const Tool& tool : model.tools) taken.push_back(tool.name);
  for (const BodyPart& body : model.bodies) taken.push_back(body.name);
  return preset_instrument(preset, bodies, taken);
}

}  // namespace fascia
