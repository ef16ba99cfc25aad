#include "base/json/json_write.h"
#include "sim/scene/tools/read_tools.h"

namespace fascia {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson number(double value) { return number_document(value); }
OrderedJson vector(const Eigen::Vector3d& v) { return vector_document(v); }

OrderedJson shape(const ToolShape& shape) {
  struct Writer {
    OrderedJson operator()(const SphereShape& s) const {
      return {{"sphere", {{"center", vector(s.center)}, {"radius", number(s.radius)}}}};
    }
    OrderedJson operator()(const CapsuleShape& s) const { return {{"capsule", segment(s.from, s.to, s.radius)}}; }
    OrderedJson operator()(const CylinderShape& s) const {
      OrderedJson cylinder = segment(s.from, s.to, s.radius);
      if (s.round > 0) cylinder["round"] = number(s.round);
      return {{"cylinder", cylinder}};
    }
    OrderedJson operator()(const BoxShape& s) const {
      return {{"box", {{"center", vector(s.center)}, {"half_size", vector(s.half_size)}, {"round", number(s.round)}}}};
    }
    OrderedJson operator()(const PlaneShape& s) const {
      return {{"plane", {{"point", vector(s.point)}, {"normal", vector(s.normal)}}}};
    }
    OrderedJson operator()(const MeshShape& s) const {
      return {{"mesh", {{"file", s.file}, {"scale", number(s.scale)}}}};
    }
    static OrderedJson segment(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius) {
      return {{"from", vector(from)}, {"to", vector(to)}, {"radius", number(radius)}};
    }
  };
  return std::visit(Writer{}, shape);
}

void add_friction(const std::optional<double>& friction, OrderedJson& object) {
  if (friction) object["friction"] = number(*friction);
}

OrderedJson instrument(const Instrument& instrument) {
  OrderedJson object = {{"name", instrument.name}};
  if (const auto* jaws = std::get_if<JawsShape>(&instrument.shape))
    object["jaws"] = {
        {"shape", shape(jaws->shape)}, {"axis", vector(jaws->axis)}, {"open_deg", number(jaws->open_deg)}};
  else
    object["shape"] = shape(std::get<ToolShape>(instrument.shape));
  add_friction(instrument.friction, object);
  const bool has_jaws = std::holds_alternative<JawsShape>(instrument.shape);
  for (const Instrument::Key& key : instrument.path) {
    OrderedJson entry = {
        {"time", number(key.time)}, {"position", vector(key.position)}, {"rotate_deg", vector(key.rotate_deg)}};
    if (has_jaws) entry["grip"] = number(key.grip);
    object["path"].push_back(std::move(entry));
  }
  object["interpolate"] = instrument.smooth ? "smooth" : "linear";
  return object;
}

}  // namespace

void write_tools(const SceneTools& tools, OrderedJson& document) {
  if (!tools.empty() || tools.contact != ContactSettings{})
    document["contact"] = {{"friction", number(tools.contact.friction)},
                           {"self", tools.contact.self},
                           {"bodies", tools.contact.bodies},
                           {"thickness", number(tools.contact.thickness)},
                           {"stiffness", number(tools.contact.stiffness)}};
  if (tools.ground) {
    document["ground"]["height"] = number(tools.ground->height);
    add_friction(tools.ground->friction, document["ground"]);
  }
  for (const Obstacle& obstacle : tools.obstacles) {
    OrderedJson object = {{"name", obstacle.name},
                          {"shape", shape(obstacle.shape)},
                          {"position", vector(obstacle.position)},
                          {"rotate_deg", vector(obstacle.rotate_deg)}};
    add_friction(obstacle.friction, object);
    document["obstacles"].push_back(std::move(object));
  }
  for (const Instrument& i : tools.instruments) document["instruments"].push_back(instrument(i));
}

}  // namespace fascia
