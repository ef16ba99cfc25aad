// Places the tissue in a picture: between the panels at the left and the color bar and plots at the right, above what
// covers the bottom, or within half of a comparison.
#pragma once
#include <Eigen/Core>

#include "render/view/camera.h"

namespace fascia {

/// Smallest height in rows at which a picture without a window is laid out around color bar and labels. In smaller ones
/// texts do not shrink further (Overlay::scale_to) and leave too little space, so the picture is not changed.
inline constexpr int kLeastRows = 360;

/// Widths covered at the edges of the picture [pixels].
struct Margins {
  double left = 0;         // panels
  double right = 0;        // legend and docked plots
  double bottom = 0;       // docked plots or the gallery
  double legend_left = 0;  // legend at the left edge, beside the panels
};

struct Frame {
  int width = 0, height = 0;  // [pixels]
  Margins margins;
  bool side = false;  // of a comparison: shows the whole body, as large as on the other side
};

/// Sets `middle` and `reach` of the camera so that the body is between panels and legend and above what covers the
/// bottom. Without any of them, and if the body is there already, the camera is unchanged. `extent`: Session::extent.
/// The result does not depend on the current camera: orbits and zooms look as they do without a bar.
void frame_picture(Camera& camera, const Eigen::Vector2d& extent, const Frame& frame);

}  // namespace fascia
