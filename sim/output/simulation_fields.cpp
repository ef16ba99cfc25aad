#include "sim/output/simulation_fields.h"

#include <Eigen/LU>
#include <algorithm>

#include "base/file.h"
#include "sim/accuracy/nodal_stress.h"
#include "sim/contact/contact_gap.h"
#include "sim/visual/shape_mesh.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

// Of a plane, a disc that covers the tissue.
double reach_of(const ToolShape& shape, const RigidPose& pose, const Model& model, const State& state) {
  double reach = 0;
  if (const auto* plane = std::get_if<PlaneShape>(&shape))
    for (std::size_t v = 0; v < model.rest_positions.size(); ++v)
      reach = std::max(reach, (model.rest_positions[v] + state.displacement[v] - pose.to_scene(plane->point)).norm());
  return 1.5 * reach;
}

ToolSurface surface_of(const Tool& tool, const ToolPlace& place, const Model& model, const State& state) {
  ToolSurface surface{tool.name, {}, {}};
  for (std::size_t piece = 0; piece < tool.piece_count(); ++piece) {
    const RigidPose pose = tool.pose_of_piece(piece, place);
    const ShapeMesh mesh = shape_mesh(tool.shape, reach_of(tool.shape, pose, model, state));
    const auto first = static_cast<std::uint32_t>(surface.positions.size());
    for (const Eigen::Vector3f& x : mesh.positions) surface.positions.push_back(pose.to_scene(x.cast<double>()));
    const bool mirrored = pose.axes.determinant() < 0;
    for (const Triangle& t : mesh.triangles)
      surface.triangles.push_back({first + t[0], first + t[mirrored ? 2 : 1], first + t[mirrored ? 1 : 2]});
  }
  return surface;
}

}  // namespace

StateFields export_fields(const Simulation& simulation, const State& state, const std::filesystem::path& path) {
  const Model& model = simulation.model;
  StateFields fields = reference::export_fields(model, state);
  if (lower_ending(path) == ".vtu" && is_finite(state)) {
    NodalStress recovered = nodal_stress(model, state);
    fields.recovered_stress = std::move(recovered.cauchy);
    fields.recovered_von_mises = std::move(recovered.von_mises);
  }
  if (!model.has_contact()) return fields;
  const std::vector<ToolPlace> places = simulation.tool_places();
  fields.contact_force = simulation.contact_forces();
  if (!model.tools.empty()) fields.contact_gap = contact_gaps(model, state, places);
  for (std::size_t t = 0; t < model.tools.size(); ++t)
    fields.tools.push_back(surface_of(model.tools[t], places[t], model, state));
  return fields;
}

}  // namespace fascia
