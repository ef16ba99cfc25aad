// What the mouse points at while it holds nothing: a place on the tissue, from the depth of the last picture. Nothing
// waits for it.
#pragma once
#include <optional>

#include "app/session/session.h"
#include "render/target/depth_probe.h"

namespace fascia {

class Hover {
 public:
  /// After a picture was drawn: takes the last answer and asks anew. Without a place nothing is pointed at.
  void look(const Framebuffer& framebuffer, const Session& session, std::optional<Eigen::Vector2d> pixel);
  const std::optional<DepthProbe::Spot>& spot() const { return spot_; }

 private:
  DepthProbe probe_;
  std::optional<DepthProbe::Spot> spot_;
};

}  // namespace fascia
