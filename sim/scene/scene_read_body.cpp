// Reads one body of a scene file: its mesh, materials, selections and motions.
#include <algorithm>
#include <charconv>
#include <limits>

#include "base/json/json_document.h"
#include "base/suggest.h"
#include "sim/material/tissue_looks.h"
#include "sim/material/tissues.h"
#include "sim/scene/scene_read.h"
#include "sim/surface/surface_fill.h"

namespace fascia {
namespace {

constexpr double kAnywhere = 1e30;    // selections may use a large number for "infinite"
constexpr double kMostTurns = 36000;  // [degrees]
constexpr double kFastest = 1e6;      // [m/s]

MaterialModel read_model(const Node& node) {
  std::vector<std::string> names;
  for (const MaterialModel model : material_models()) names.push_back(name_of(model));
  const std::string expected = "a model that exists: " + join(names);
  const std::string name = node.text(expected);
  const auto model = find_material_model(name);
  if (!model) node.fail("is " + excerpt(name) + perhaps(name, names), expected);
  return *model;
}

const TissueLook& read_look(const Node& node) {
  const std::string expected = "a look that exists: " + join(look_names());
  const std::string name = node.text(expected);
  const TissueLook* look = find_look(name);
  if (!look) node.fail("is " + excerpt(name) + perhaps(name, look_names()), expected);
  return *look;
}

std::array<double, 3> read_color(const Node& node) {
  const Eigen::Vector3d color = node.vector(0, 1, "");
  return {color.x(), color.y(), color.z()};
}

const Tissue& read_preset(const Node& node) {
  std::string listed;
  for (const std::string& name : tissue_names()) listed += (listed.empty() ? "" : ", ") + name;
  const std::string expected = "a tissue that fascia info --tissues lists: " + listed;
  const std::string name = node.text(expected);
  const Tissue* tissue = find_tissue(name);
  if (!tissue) node.fail("is " + excerpt(name) + perhaps(name, tissue_names()), expected);
  return *tissue;
}

/// Reads a Material or a MaterialOverride: given keys replace the values of `material`, and a preset's values replace
/// those of keys that are not given.
template <class M>
void read_material(const Node& node, M& material) {
  std::vector<std::string> known = {"model", "preset"};
  visit_material(material, [&](auto&, const char* name, auto&&...) { known.push_back(name); });
  known.insert(known.end(), {"look", "color"});
  node.expect_object(known);
  if (const auto preset = node.find("preset")) {
    const Tissue& tissue = read_preset(*preset);
    material.young_modulus = tissue.young_modulus;
    material.poisson_ratio = tissue.poisson_ratio;
    material.density = tissue.density;
    material.look = find_look(tissue.look);
  }
  visit_material(material, [&](auto& field, const char* name, const char* unit, double min, double max, auto&&...) {
    if (const auto value = node.find(name)) field = value->number(min, max, unit);
  });
  if (const auto model = node.find("model")) material.model = read_model(*model);
  if (const auto look = node.find("look")) material.look = &read_look(*look);
  if (const auto color = node.find("color")) material.color = read_color(*color);
}

void read_materials(const Node& node, Body& body) {
  const std::string expected = "an object of materials: \"default\", region numbers or group names";
  for (const auto& [key, value] : node.members(expected)) {
    if (!value.is_object()) {
      value.refuse("an object such as {\"young_modulus\": 1e5}, under \"default\", a region number or a group name");
    }
    if (key == "default") {
      read_material(value, body.material);
    } else {
      read_material(value, body.region_materials.emplace_back(key, MaterialOverride{}).second);
    }
  }
}

std::string shortest(double number) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, number).ptr};
}

Selection read_box(const Node& node) {
  const std::string expected = "a list of two corners, [[xmin, ymin, zmin], [xmax, ymax, zmax]] [m]";
  const std::vector<Node> corners = node.elements(expected);
  if (corners.size() != 2) node.refuse(expected);
  const BoxSelection box{corners[0].vector(-kAnywhere, kAnywhere, "m"), corners[1].vector(-kAnywhere, kAnywhere, "m")};
  std::string swapped;
  for (const int axis : {0, 1, 2}) {
    if (box.min[axis] <= box.max[axis]) continue;
    swapped += (swapped.empty() ? " along " : " and along ") + std::string(1, "xyz"[axis]) + " (first corner " +
               shortest(box.min[axis]) + ", second corner " + shortest(box.max[axis]) + ")";
  }
  if (!swapped.empty()) node.fail("has min > max" + swapped, expected);
  return box;
}

Selection read_sphere(const Node& node) {
  node.expect_object({"center", "radius"});
  const Node center = node.at("center", "a list of 3 numbers [m]"), radius = node.at("radius", "a radius [m]");
  return SphereSelection{center.vector(-kAnywhere, kAnywhere, "m"), radius.number(0, kAnywhere, "m")};
}

Selection read_vertices(const Node& node) {
  VertexSelection selection;
  for (const Node& index : node.elements("a list of vertex indices, the first vertex is 0")) {
    selection.vertices.push_back(static_cast<std::uint32_t>(index.integer(0, std::numeric_limits<int>::max())));
  }
  if (selection.vertices.empty()) node.refuse("at least one vertex index");
  return selection;
}

/// An index, or the first and the last one of a range.
TetRange read_tets(const Node& node) {
  constexpr int kLast = std::numeric_limits<int>::max();
  if (!node.is_array()) {
    const auto index = static_cast<std::uint32_t>(node.integer(0, kLast));
    return {index, index};
  }
  const std::string expected = "a tet, or the first and the last tet of a range";
  const std::vector<Node> ends = node.elements(expected);
  if (ends.size() != 2) node.refuse(expected);
  const TetRange range{static_cast<std::uint32_t>(ends[0].integer(0, kLast)),
                       static_cast<std::uint32_t>(ends[1].integer(0, kLast))};
  if (range.first > range.last) node.fail("ends before it begins", expected);
  return range;
}

TetRegion read_region(const Node& node) {
  node.expect_object({"name", "tets"});
  const Node name = node.at("name", "the name of a region"),
             tets = node.at("tets", "a list of tets and of ranges [first, last], the first tet is 0");
  TetRegion region{name.text("the name of a region"), {}};
  if (region.name.empty() || region.name == "default") name.refuse("the name of a region, not empty or \"default\"");
  for (const Node& element : tets.elements("a list of tets and of ranges [first, last], the first tet is 0"))
    region.tets.push_back(read_tets(element));
  if (region.tets.empty()) tets.refuse("at least one tet");
  region.tets = joined(std::move(region.tets));
  return region;
}

std::vector<TetRegion> read_regions(const Node& node) {
  std::vector<TetRegion> regions;
  for (const Node& element : node.elements("a list of regions such as {\"name\": \"tumor\", \"tets\": [3, [8, 20]]}")) {
    TetRegion region = read_region(element);
    if (std::any_of(regions.begin(), regions.end(), [&](const TetRegion& r) { return r.name == region.name; }))
      element.fail("has the name " + excerpt(region.name) + " of an earlier one", "one entry per region");
    regions.push_back(std::move(region));
  }
  return regions;
}

PrescribedMotion read_motion(const Node& node) {
  node.expect_object({"select", "translate", "rotate_deg", "scale", "targets", "start", "duration"});
  PrescribedMotion motion;
  node.read("start", motion.start, 0, kLongestTime, "s");
  node.read("duration", motion.duration, 0, kLongestTime, "s");
  if (const auto select = node.find("select")) motion.select = read_selection(*select);
  if (const auto targets = node.find("targets")) {
    for (const char* key : {"translate", "rotate_deg", "scale"}) {
      if (node.find(key)) node.fail("has targets and " + std::string(key), "one of them");
    }
    motion.targets = targets->text("the path of a CSV file index,x,y,z");
    if (motion.targets.empty()) targets->refuse("the path of a CSV file index,x,y,z");
    return motion;
  }
  if (!motion.select) node.fail("moves nothing", "a select, or targets");
  node.read("translate", motion.translate, -kFarthestTissue, kFarthestTissue, "m");
  node.read("scale", motion.scale, 1e-3, 1e3, "");
  if (const auto rotate = node.find("rotate_deg")) {
    rotate->expect_object({"axis", "angle", "center"});
    rotate->read("axis", motion.axis, -kFarthestTissue, kFarthestTissue, "");
    rotate->read("angle", motion.angle_deg, -kMostTurns, kMostTurns, "degrees");
    rotate->read("center", motion.center, -kFarthestTissue, kFarthestTissue, "m");
    if (motion.axis.norm() < 1e-6) rotate->fail("axis has no direction", "an axis of length 1e-06 or more");
  }
  return motion;
}

/// One of `choices` by its name.
template <class Choice, std::size_t n>
Choice read_choice(const Node& node, const std::array<Choice, n>& choices) {
  std::vector<std::string> names;
  for (const Choice choice : choices) names.emplace_back(name_of(choice));
  const std::string expected = "one of " + join(names), text = node.text(expected);
  const auto found = std::find(names.begin(), names.end(), text);
  if (found == names.end()) node.refuse(expected);
  return choices[static_cast<std::size_t>(found - names.begin())];
}

std::variant<Eigen::Vector3d, std::string> read_velocity(const Node& node) {
  const std::string expected = "a list of 3 numbers [m/s] or the path of a CSV file";
  if (!node.is_string()) {
    if (node.elements(expected).size() != 3) node.refuse(expected);
    return node.vector(-kFastest, kFastest, "m/s");
  }
  std::string path = node.text(expected);
  if (path.empty()) node.refuse(expected);
  return path;
}

Transform read_transform(const Node& node) {
  Transform transform;
  node.expect_object({"scale", "rotate_deg", "translate"});
  node.read("scale", transform.scale, 1e-9, 1e9, "");
  node.read("rotate_deg", transform.rotate_deg, -kMostTurns, kMostTurns, "degrees");
  node.read("translate", transform.translate, -kFarthestTissue, kFarthestTissue, "m");
  return transform;
}

}  // namespace

Selection read_selection(const Node& node) {
  const std::vector<std::string> kinds = {"box", "sphere", "vertices", "group", "lowest", "highest"};
  std::vector<std::string> known = kinds;
  known.emplace_back("each_piece");
  node.expect_object(known);
  std::optional<Node> found;
  std::string kind;
  for (const std::string& candidate : kinds) {
    const auto value = node.find(candidate);
    if (!value) continue;
    if (found) node.fail("has " + kind + " and " + candidate, "one of " + join(kinds));
    found = value;
    kind = candidate;
  }
  if (!found) node.fail("selects nothing", "one of " + join(kinds));
  const auto each_piece = node.find("each_piece");
  if (each_piece && kind != "lowest" && kind != "highest")
    each_piece->fail("is given beside " + kind, "it beside lowest or highest only");
  if (kind == "box") return read_box(*found);
  if (kind == "sphere") return read_sphere(*found);
  if (kind == "vertices") return read_vertices(*found);
  if (kind == "group") return GroupSelection{found->text("the name of a group of the mesh")};
  return LowestSelection{found->number(0, 1, "of the height"), kind == "highest", each_piece && each_piece->boolean()};
}

Material read_material(const Node& node) {
  Material material;
  read_material(node, material);
  return material;
}

Body read_body(const Node& node) {
  node.expect_object({"name", "mesh", "resolution", "elements", "unit", "up", "transform", "materials", "regions",
                      "fixed", "prescribed", "initial_velocity", "surface"});
  Body body;
  const std::string expected = "the path of a tet mesh or of a closed surface";
  const Node mesh = node.at("mesh", expected);
  body.mesh = mesh.text(expected);
  if (body.mesh.empty()) mesh.refuse(expected);
  if (const auto resolution = node.find("resolution")) body.resolution = resolution->integer(kFewestCells, kMostCells);
  if (const auto elements = node.find("elements")) body.elements = read_choice(*elements, kElementOrders);
  if (const auto name = node.find("name")) body.name = name->text("a text");
  if (const auto unit = node.find("unit")) body.unit = read_choice(*unit, kLengthUnits);
  if (const auto up = node.find("up")) body.up = read_choice(*up, kUpAxes);
  if (const auto transform = node.find("transform")) body.transform = read_transform(*transform);
  if (const auto materials = node.find("materials")) read_materials(*materials, body);
  if (const auto regions = node.find("regions")) body.regions = read_regions(*regions);
  if (const auto fixed = node.find("fixed")) {
    for (const Node& selection : fixed->elements("a list of selections")) {
      body.fixed.push_back(read_selection(selection));
    }
  }
  if (const auto prescribed = node.find("prescribed")) {
    for (const Node& motion : prescribed->elements("a list of motions")) body.prescribed.push_back(read_motion(motion));
  }
  if (const auto velocity = node.find("initial_velocity")) body.initial_velocity = read_velocity(*velocity);
  if (const auto surface = node.find("surface")) body.surface = surface->text("the path of a surface");
  return body;
}

}  // namespace fascia
