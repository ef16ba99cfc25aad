#include "app/window/parts/hover.h"

#include <cmath>

namespace fascia {

void Hover::look(const Framebuffer& framebuffer, const Session& session, std::optional<Eigen::Vector2d> pixel) {
  if (probe_.take(spot_) && spot_) {
    const Look& look = session.look;
    const double above_ground = spot_->point.dot(look.up.normalized()) - look.ground_height;
    if (look.ground && std::abs(above_ground) < 1e-3 * look.radius) spot_.reset();
  }
  const bool inside = pixel && pixel->x() >= 0 && pixel->y() >= 0 && pixel->x() < framebuffer.width() &&
                      pixel->y() < framebuffer.height();
  if (!inside) {
    spot_.reset();
    return;
  }
  const Camera& camera = session.camera;
  const double aspect = static_cast<double>(framebuffer.width()) / framebuffer.height();
  probe_.request(framebuffer, static_cast<int>(pixel->x()), static_cast<int>(pixel->y()),
                 (camera.projection(aspect, session.look.radius) * camera.view()).cast<double>());
}

}  // namespace fascia
