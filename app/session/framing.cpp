#include "app/session/framing.h"

#include <algorithm>

namespace fascia {

void frame_picture(Camera& camera, const Eigen::Vector2d& extent, const Frame& frame) {
  constexpr double kGap = 0.02;  // at both ends of the free space, as a share of it
  // Limit of `extent`: a body that extends farther, beyond the picture, is intentionally shown in part
  constexpr double kWidest = 1.3;
  const double width = frame.width, left = frame.margins.left, right = frame.margins.right,
               legend = frame.margins.legend_left, room = std::max(width - left - legend - right, 1.0);
  const double height = std::max(frame.height - frame.margins.bottom, 1.0);
  const auto half_of = [&](double across, double along) { return 0.5 * std::min(across, along); };
  // Without a legend the target is in the center of the space beside the panels, and the lens spans the shorter side of
  // the picture, above what covers its bottom. Both sides of a comparison are drawn in this manner, whichever has the
  // legend.
  double target = 0.5 * (frame.side ? left - right : left);  // from the picture's middle to the right
  const double half = half_of(frame.side ? room : width, height);
  camera.reach = half_of(width, frame.height) / half;
  if (left > 0 || right > 0 || legend > 0 || frame.margins.bottom > 0 || frame.side) {
    const double most = std::max(kWidest, 0.5 * (frame.side ? room : width - left) / half);
    const Eigen::Vector2d body = extent.cwiseMax(-most).cwiseMin(most) * half;
    const double begin = left + legend + kGap * room - 0.5 * width, end = begin + (1 - 2 * kGap) * room;
    const double smaller = std::max(1.0, (body.y() - body.x()) / (end - begin));
    camera.reach *= smaller;
    target = std::min(std::max(target, begin - body.x() / smaller), end - body.y() / smaller);
  }
  camera.middle = {target / (0.5 * width), frame.margins.bottom / frame.height};
}

}  // namespace fascia
