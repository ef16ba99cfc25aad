#include "sim/scene/tools/read_tools.h"

#include <algorithm>

#include "base/json/json_document.h"
#include "base/suggest.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

using tool_limits::kFarthest;
using tool_limits::kLongest;
using tool_limits::kSmallest;
constexpr double kMostFriction = 10;
constexpr double kMostTurns = 1000;
const std::vector<std::string> kShapes(kShapeNames.begin(), kShapeNames.end());

Vector3d place(const Node& node, const char* key, const char* expected) {
  return node.at(key, expected).vector(-kFarthest, kFarthest, "m");
}

double radius_of(const Node& node) { return node.at("radius", "meters").number(kSmallest, kFarthest, "m"); }

Vector3d direction(const Node& node) {
  const Vector3d v = node.vector(-kFarthest, kFarthest, "");
  if (v.isZero(0)) node.refuse("a direction other than [0, 0, 0]");
  return v;
}

SphereShape read_sphere(const Node& node) {
  node.expect_object({"center", "radius"});
  SphereShape sphere;
  node.read("center", sphere.center, -kFarthest, kFarthest, "m");
  sphere.radius = radius_of(node);
  return sphere;
}

template <class Shape>
Shape read_segment(const Node& node) {
  Shape shape;
  shape.from = place(node, "from", "one end of the axis [x, y, z] [m]");
  shape.to = place(node, "to", "the other end of the axis [x, y, z] [m]");
  shape.radius = radius_of(node);
  if ((shape.to - shape.from).norm() < kSmallest) node.fail("from and to are the same point", "two different points");
  return shape;
}

CapsuleShape read_capsule(const Node& node) {
  node.expect_object({"from", "to", "radius"});
  return read_segment<CapsuleShape>(node);
}

CylinderShape read_cylinder(const Node& node) {
  node.expect_object({"from", "to", "radius", "round"});
  auto cylinder = read_segment<CylinderShape>(node);
  const double most = std::min(cylinder.radius, 0.5 * (cylinder.to - cylinder.from).norm());
  node.read("round", cylinder.round, 0, most, "m, at most the radius and half of the length");
  return cylinder;
}

BoxShape read_box(const Node& node) {
  node.expect_object({"center", "half_size", "round"});
  BoxShape box;
  node.read("center", box.center, -kFarthest, kFarthest, "m");
  box.half_size = node.at("half_size", "half of the edges [x, y, z] [m]").vector(kSmallest, kFarthest, "m");
  node.read("round", box.round, 0, box.half_size.minCoeff(), "m, at most the smallest half_size");
  return box;
}

PlaneShape read_plane(const Node& node) {
  node.expect_object({"point", "normal"});
  PlaneShape plane;
  node.read("point", plane.point, -kFarthest, kFarthest, "m");
  plane.normal = direction(node.at("normal", "a direction [x, y, z] away from the solid"));
  return plane;
}

MeshShape read_mesh_shape(const Node& node) {
  node.expect_object({"file", "scale"});
  MeshShape mesh;
  const std::string expected = "the path of a closed surface";
  const Node file = node.at("file", expected);
  mesh.file = file.text(expected);
  if (mesh.file.empty()) file.refuse(expected);
  node.read("scale", mesh.scale, kSmallest, kFarthest, "m of a unit of the file");
  return mesh;
}

ToolShape read_shape(const Node& node) {
  node.expect_object(kShapes);
  const std::string expected = "one of " + join(kShapes);
  const auto members = node.members(expected);
  if (members.size() != 1) node.fail(members.empty() ? "is empty" : "has more than one shape", expected);
  const auto& [name, shape] = members.front();
  if (name == "sphere") return read_sphere(shape);
  if (name == "capsule") return read_capsule(shape);
  if (name == "cylinder") return read_cylinder(shape);
  if (name == "box") return read_box(shape);
  if (name == "mesh") return read_mesh_shape(shape);
  return read_plane(shape);
}

JawsShape read_jaws(const Node& node) {
  node.expect_object({"shape", "axis", "open_deg"});
  JawsShape jaws;
  const Node shape = node.at("shape", "the shape of one jaw");
  jaws.shape = read_shape(shape);
  if (std::holds_alternative<PlaneShape>(jaws.shape)) shape.fail("is a plane", "a shape of finite size");
  if (const auto axis = node.find("axis")) jaws.axis = direction(*axis);
  node.read("open_deg", jaws.open_deg, 0, 180, "degrees");
  return jaws;
}

std::optional<double> read_friction(const Node& node) {
  const auto friction = node.find("friction");
  return friction ? std::optional(friction->number(0, kMostFriction, "")) : std::nullopt;
}

Vector3d read_angles(const Node& node) { return node.vector(-360 * kMostTurns, 360 * kMostTurns, "degrees"); }

Instrument::Key read_key(const Node& node, const Instrument::Key& before, bool has_jaws) {
  node.expect_object({"time", "position", "rotate_deg", "grip"});
  Instrument::Key key = before;
  key.time = node.at("time", "seconds").number(0, kLongest, "s");
  node.read("position", key.position, -kFarthest, kFarthest, "m");
  if (const auto angles = node.find("rotate_deg")) key.rotate_deg = read_angles(*angles);
  if (const auto grip = node.find("grip")) {
    key.grip = grip->number(0, 1, "");
    if (!has_jaws) grip->fail("has no jaws to close", "jaws instead of shape");
  }
  return key;
}

Instrument read_instrument(const Node& node) {
  node.expect_object({"name", "shape", "jaws", "friction", "path", "interpolate"});
  Instrument instrument;
  instrument.name = node.at("name", "a name, which statistics use").text("a name, which statistics use");
  const auto shape = node.find("shape"), jaws = node.find("jaws");
  if (shape.has_value() == jaws.has_value())
    node.fail(shape ? "has shape and jaws" : "has no shape", "one of shape and jaws");
  if (shape)
    instrument.shape = read_shape(*shape);
  else
    instrument.shape = read_jaws(*jaws);
  instrument.friction = read_friction(node);
  if (const auto path = node.find("path")) {
    const std::string expected = "a list of keys, times ascending, such as {\"time\": 0, \"position\": [0, 0.1, 0]}";
    for (const Node& element : path->elements(expected)) {
      const Instrument::Key before = instrument.path.empty() ? Instrument::Key{} : instrument.path.back();
      instrument.path.push_back(read_key(element, before, jaws.has_value()));
      if (instrument.path.size() > 1 && !(before.time < instrument.path.back().time))
        element.fail("time is " + excerpt(instrument.path.back().time), "a later time than that of the key before");
    }
    if (instrument.path.empty()) path->refuse(expected);
  } else {
    instrument.path.emplace_back();
  }
  if (const auto interpolate = node.find("interpolate")) {
    const std::string expected = "\"linear\" or \"smooth\"", text = interpolate->text(expected);
    if (text != "linear" && text != "smooth") interpolate->refuse(expected);
    instrument.smooth = text == "smooth";
  }
  return instrument;
}

Obstacle read_obstacle(const Node& node) {
  node.expect_object({"name", "shape", "position", "rotate_deg", "friction"});
  Obstacle obstacle;
  obstacle.name = node.at("name", "a name, which statistics use").text("a name, which statistics use");
  obstacle.shape = read_shape(node.at("shape", "a shape: one of " + join(kShapes)));
  node.read("position", obstacle.position, -kFarthest, kFarthest, "m");
  if (const auto angles = node.find("rotate_deg")) obstacle.rotate_deg = read_angles(*angles);
  obstacle.friction = read_friction(node);
  return obstacle;
}

Ground read_ground(const Node& node) {
  node.expect_object({"height", "friction"});
  Ground ground;
  node.read("height", ground.height, -kFarthest, kFarthest, "m");
  ground.friction = read_friction(node);
  return ground;
}

ContactSettings read_contact(const Node& node) {
  node.expect_object({"friction", "self", "bodies", "thickness", "stiffness"});
  ContactSettings contact;
  node.read("friction", contact.friction, 0, kMostFriction, "");
  node.read("thickness", contact.thickness, 0, kFarthest, "m");
  node.read("stiffness", contact.stiffness, 1e-3, 1e3, "");
  contact.bodies = true;
  if (const auto bodies = node.find("bodies")) contact.bodies = bodies->boolean();
  if (const auto self = node.find("self")) contact.self = self->boolean();
  return contact;
}

}  // namespace

SceneTools read_tools(const Node& root, SceneNames& names) {
  SceneTools tools;
  if (const auto contact = root.find("contact")) tools.contact = read_contact(*contact);
  if (const auto ground = root.find("ground")) tools.ground = read_ground(*ground);
  if (const auto obstacles = root.find("obstacles"))
    for (const Node& node : obstacles->elements("a list of obstacles")) {
      const std::string owner = "obstacles[" + std::to_string(tools.obstacles.size()) + "]";
      tools.obstacles.push_back(read_obstacle(node));
      names.claim(node, tools.obstacles.back().name, owner);
    }
  if (const auto instruments = root.find("instruments"))
    for (const Node& node : instruments->elements("a list of instruments")) {
      const std::string owner = "instruments[" + std::to_string(tools.instruments.size()) + "]";
      tools.instruments.push_back(read_instrument(node));
      names.claim(node, tools.instruments.back().name, owner);
    }
  return tools;
}

}  // namespace fascia
