#include "sim/contact/contact_gap.h"

#include <algorithm>
#include <limits>

#include "sim/contact/tissue/tissue_surface.h"
#include "sim/tool/shape_distance.h"

namespace fascia {

std::vector<double> contact_gaps(const Model& model, const State& state, const std::vector<ToolPlace>& places) {
  const std::vector<double> areas = tissue_areas(model, tissue_boundary(model));
  std::vector<double> gaps(areas.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t v = 0; v < gaps.size(); ++v) {
    if (areas[v] == 0) continue;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t t = 0; t < places.size(); ++t)
      for (std::size_t piece = 0; piece < model.tools[t].piece_count(); ++piece) {
        const RigidPose pose = model.tools[t].pose_of_piece(piece, places[t]);
        const Eigen::Vector3d local = pose.to_local(model.rest_positions[v] + state.displacement[v]);
        nearest = std::min(nearest, gap_to(model.tools[t].shape, local));
      }
    gaps[v] = nearest - 0.5 * model.contact.thickness;
  }
  return gaps;
}

}  // namespace fascia
