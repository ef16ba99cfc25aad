#include "sim/scene/tools/scale_tools.h"

namespace fascia {
namespace {

void scale_lengths(ToolShape& shape, double factor) {
  struct Scaler {
    double factor;
    void operator()(SphereShape& s) const {
      s.center *= factor;
      s.radius *= factor;
    }
    void operator()(CapsuleShape& s) const { segment(s.from, s.to, s.radius); }
    void operator()(CylinderShape& s) const {
      segment(s.from, s.to, s.radius);
      s.round *= factor;
    }
    void operator()(BoxShape& s) const {
      s.center *= factor;
      s.half_size *= factor;
      s.round *= factor;
    }
    void operator()(PlaneShape& s) const { s.point *= factor; }
    void operator()(MeshShape& s) const { s.scale *= factor; }
    void segment(Eigen::Vector3d& from, Eigen::Vector3d& to, double& radius) const {
      from *= factor;
      to *= factor;
      radius *= factor;
    }
  };
  std::visit(Scaler{factor}, shape);
}

}  // namespace

void scale_lengths(SceneTools& tools, double factor) {
  tools.contact.thickness *= factor;
  if (tools.ground) tools.ground->height *= factor;
  for_each_shape(tools, [&](ToolShape& shape, const std::string&) { scale_lengths(shape, factor); });
  for (Obstacle& obstacle : tools.obstacles) obstacle.position *= factor;
  for (Instrument& instrument : tools.instruments)
    for (Instrument::Key& key : instrument.path) key.position *= factor;
}

}  // namespace fascia
