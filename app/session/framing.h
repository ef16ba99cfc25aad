// Where a picture shows the tissue: beside the panels at its left and the color bar at its right, or within half of a
// comparison.
#pragma once
#include <Eigen/Core>

#include "render/view/camera.h"

namespace fascia {

/// Rows of a picture without a window from which on it is laid out around color bar and labels. In smaller ones texts
/// shrink no more (Overlay::scale_to) and leave too little: they stay as they were composed.
inline constexpr int kLeastRows = 360;

/// What is drawn over the edges of a picture [pixels].
struct Margins {
  double left = 0;   // panels
  double right = 0;  // color bar
};

struct Frame {
  int width = 0, height = 0;  // [pixels]
  Margins margins;
  bool side = false;  // of a comparison: all of the body is seen, and as large as at the other side
};

/// Sets `middle` and `reach` of the camera so that the body stands between panels and color bar; without a bar, and
/// where it stands there anyway, the picture stays as the camera has it. `extent`: Session::extent. Where the camera is
/// now does not matter: orbits and zooms look as they do without a bar.
void frame_picture(Camera& camera, const Eigen::Vector2d& extent, const Frame& frame);

}  // namespace fascia
