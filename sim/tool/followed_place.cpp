#include "sim/tool/followed_place.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "sim/tool/shape_distance.h"
#include "sim/tool/tool_motion.h"

namespace fascia {
namespace {

constexpr double kStride = 0.25;  // of the radius
constexpr double kLargest = 0.1;  // of the size of the tissue
constexpr int kMostLooks = 64;    // at the tissue in a step; then the tool waits for the next one

}  // namespace

double followed_radius(const Tool& tool, double tissue_size) {
  return std::min(finest_radius(tool.shape), kLargest * tissue_size);
}

double way_between(const Tool& tool, const ToolPlace& from, const ToolPlace& to, double tissue_size) {
  const double reach = middle_of(tool.shape).norm() + std::min(bounding_radius(tool.shape), tissue_size);
  const double turn = std::abs(Eigen::AngleAxisd(to.pose.axes * from.pose.axes.transpose()).angle());
  const double closing = tool.has_jaws ? std::abs(tool.open * (to.grip - from.grip)) : 0;
  return (to.pose.origin - from.pose.origin).norm() + (turn + closing) * reach;
}

ToolPlace followed_place(const Tool& tool, const ToolPlace& now, const ToolPlace& commanded, double tissue_size,
                         const Clearance& clearance) {
  const double whole = way_between(tool, now, commanded, tissue_size);
  if (!(whole > 0)) return commanded;
  const double radius = followed_radius(tool, tissue_size), stride = kStride * radius;
  double way = 0;
  for (int look = 0; look < kMostLooks && way < whole; ++look) {
    const double free = clearance(between(now, commanded, way / whole)) - radius;
    if (free > 0) {
      way += free + stride;
      continue;
    }
    if (look == 0) way = stride;
    break;
  }
  return between(now, commanded, way / whole);
}

}  // namespace fascia
