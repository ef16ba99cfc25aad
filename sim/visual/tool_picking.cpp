#include "sim/visual/tool_picking.h"

#include <cmath>

#include "sim/tool/shape_distance.h"

namespace fascia {
namespace {

// Sphere tracing (Hart 1996): no step is longer than the distance to the shape.
std::optional<double> trace(const Ray& ray, const ToolShape& shape, const RigidPose& pose) {
  constexpr double kFarthest = 1e3;  // [m]
  constexpr int kMostSteps = 256;
  const double near = 1e-3 * std::min(finest_radius(shape), 1.0);
  double way = 0;
  for (int step = 0; step < kMostSteps && way < kFarthest; ++step) {
    const double distance = distance_to(shape, pose.to_local(ray.origin + way * ray.direction)).distance;
    if (distance < near) return way;
    way += distance;
  }
  return std::nullopt;
}

}  // namespace

std::optional<ToolHit> pick_tool(const Ray& ray, const std::vector<Tool>& tools, const std::vector<ToolPlace>& places,
                                 std::size_t first) {
  std::optional<ToolHit> nearest;
  for (std::size_t t = first; t < tools.size(); ++t)
    for (std::size_t piece = 0; piece < tools[t].piece_count(); ++piece) {
      const auto way = trace(ray, tools[t].shape, tools[t].pose_of_piece(piece, places[t]));
      if (way && (!nearest || *way < nearest->distance)) nearest = ToolHit{t, *way};
    }
  return nearest;
}

}  // namespace fascia
