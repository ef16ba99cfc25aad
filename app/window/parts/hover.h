// The place on the tissue under the mouse while the mouse holds nothing, from the depth of the last picture. Reading
// the depth never waits for the GPU.
#pragma once
#include <optional>

#include "app/session/session.h"
#include "render/target/depth_probe.h"

namespace fascia {

class Hover {
 public:
  /// After a picture was drawn: takes the last result and requests the next one. Without a pixel there is no spot.
  void look(const Framebuffer& framebuffer, const Session& session, std::optional<Eigen::Vector2d> pixel);
  const std::optional<DepthProbe::Spot>& spot() const { return spot_; }

 private:
  DepthProbe probe_;
  std::optional<DepthProbe::Spot> spot_;
};

}  // namespace fascia
