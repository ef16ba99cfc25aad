// Every setting is written, with the fewest digits that read back to the same number.
#include "sim/scene/scene_write.h"

#include "base/byte_hash.h"
#include "base/byte_text.h"
#include "base/json/json_write.h"
#include "sim/material/law.h"
#include "sim/material/tissue_looks.h"
#include "sim/scene/scene_paths.h"
#include "sim/scene/tools/read_tools.h"

namespace fascia {
namespace {

namespace fs = std::filesystem;
using OrderedJson = nlohmann::ordered_json;

OrderedJson number(double value) { return number_document(value); }
OrderedJson vector(const Eigen::Vector3d& v) { return vector_document(v); }

OrderedJson selection(const Selection& selection) {
  struct Writer {
    OrderedJson& object;
    void operator()(const BoxSelection& s) { object["box"] = OrderedJson::array({vector(s.min), vector(s.max)}); }
    void operator()(const SphereSelection& s) {
      object["sphere"] = {{"center", vector(s.center)}, {"radius", number(s.radius)}};
    }
    void operator()(const VertexSelection& s) { object["vertices"] = s.vertices; }
    void operator()(const GroupSelection& s) { object["group"] = s.group; }
    void operator()(const LowestSelection& s) {
      object[s.highest ? "highest" : "lowest"] = number(s.share);
      if (s.each_piece) object["each_piece"] = true;
    }
  };
  OrderedJson object;
  std::visit(Writer{object}, selection);
  return object;
}

OrderedJson region(const TetRegion& region) {
  OrderedJson tets = OrderedJson::array();
  for (const auto& [first, last] : region.tets)
    tets.push_back(first == last ? OrderedJson(first) : OrderedJson::array({first, last}));
  return {{"name", region.name}, {"tets", std::move(tets)}};
}

/// The values of a Material or a MaterialOverride. A default that the law of a Material does not read is left out.
template <class M>
OrderedJson material(const M& material) {
  OrderedJson object = OrderedJson::object();
  std::vector<double> defaults;
  const Material usual;
  visit_material(usual, [&](double value, auto&&...) { defaults.push_back(value); });
  std::size_t i = 0;
  visit_material(material, [&](const auto& field, const char* name, auto&&...) {
    const std::optional<double> value = field;
    bool says_something = value.has_value();
    if constexpr (std::is_same_v<M, Material>) says_something = reads(material.model, name) || field != defaults[i];
    if (says_something) object[name] = number(*value);
    ++i;
  });
  if (const std::optional<MaterialModel> model = material.model) object["model"] = name_of(*model);
  if (material.look) object["look"] = material.look->name;
  if (material.color) {
    const auto [red, green, blue] = *material.color;
    object["color"] = {number(red), number(green), number(blue)};
  }
  return object;
}

// The value of one display setting, by its type.
OrderedJson setting(bool on) { return on; }
OrderedJson setting(double share) { return number(share); }
template <class Choice>
requires std::is_enum_v<Choice> OrderedJson setting(Choice choice) { return name_of(choice); }
OrderedJson setting(const Eigen::Vector3d& place) { return vector(place); }
OrderedJson setting(const Eigen::Vector2d& range) { return {number(range[0]), number(range[1])}; }
OrderedJson setting(const SectionPlane& section) {
  return {{"normal", vector(section.normal)}, {"offset", number(section.offset)}};
}
OrderedJson setting(const SeparateTets& tets) {
  return {{"shrink", number(tets.shrink)}, {"spread", number(tets.spread)}};
}
OrderedJson setting(const MarkSettings& marks) {
  OrderedJson shown = OrderedJson::array();
  std::size_t kinds = 0;
  visit_marks(marks, [&](bool on, const char* name, auto&&...) {
    ++kinds;
    if (on) shown.push_back(name);
  });
  if (shown.empty() || shown.size() == kinds) return !shown.empty();
  return shown;
}
OrderedJson setting(const LegendSettings& legend) {
  return {{"side", name_of(legend.side)}, {"font_size", number(legend.font_size)}, {"plate", legend.plate}};
}
template <class Part>
OrderedJson setting(const std::optional<Part>& part) {
  return part ? setting(*part) : OrderedJson();
}

OrderedJson display(const DisplaySettings& display) {
  OrderedJson object = OrderedJson::object();
  visit_display(display, [&](const auto& field, const char* key, auto&&...) {
    if (OrderedJson value = setting(field); !value.is_null()) object[key] = std::move(value);
  });
  return object;
}

class SceneWriter {
 public:
  SceneWriter(const Scene& scene, const fs::path& folder) : scene_(scene), folder_(folder) {}

  OrderedJson write() const {
    OrderedJson object = {{"fascia_scene", 1}, {"title", scene_.title}, {"gravity", vector(scene_.gravity)}};
    for (const Body& b : scene_.bodies) object["bodies"].push_back(body(b));
    for (const ScriptedGrab& g : scene_.grabs) object["grabs"].push_back(grab(g));
    SceneTools tools = scene_.tools;
    for_each_shape(tools, [&](ToolShape& shape, const std::string&) {
      if (auto* mesh = std::get_if<MeshShape>(&shape)) mesh->file = path(mesh->file);
    });
    write_tools(tools, object);
    object["solver"] = solver_document(scene_.solver);
    if (scene_.camera) object["camera"] = camera_document(*scene_.camera);
    if (const CameraMotion& motion = scene_.camera_motion; !motion.keys.empty()) {
      for (const CameraKey& key : motion.keys) object["camera"]["keys"].push_back(camera_key(key));
      object["camera"]["smooth"] = motion.smooth;
    }
    object["display"] = display_document(scene_.display);
    object["duration"] = number(scene_.duration);
    return object;
  }

  OrderedJson files() const {
    OrderedJson list = OrderedJson::array();
    for (const KnownFile& file : scene_.files) {
      list.push_back({{"path", path(file.path)}, {"size", file.size}, {"hash", hash_text(file.hash)}});
      if (file.deflated) list.back()["deflated"] = base64_encoded(*file.deflated);
    }
    return list;
  }

 private:
  OrderedJson body(const Body& body) const {
    OrderedJson object = {{"name", body.name}, {"mesh", path(body.mesh)}};
    if (body.resolution) object["resolution"] = *body.resolution;
    if (body.elements != ElementOrder::linear) object["elements"] = name_of(body.elements);
    if (body.unit != LengthUnit::m) object["unit"] = name_of(body.unit);
    if (body.up != UpAxis::y) object["up"] = name_of(body.up);
    object["transform"] = {{"scale", number(body.transform.scale)},
                           {"rotate_deg", vector(body.transform.rotate_deg)},
                           {"translate", vector(body.transform.translate)}};
    object["materials"]["default"] = material(body.material);
    for (const auto& [region, values] : body.region_materials) object["materials"][region] = material(values);
    for (const TetRegion& r : body.regions) object["regions"].push_back(region(r));
    object["fixed"] = OrderedJson::array();
    for (const Selection& s : body.fixed) object["fixed"].push_back(selection(s));
    object["prescribed"] = OrderedJson::array();
    for (const PrescribedMotion& m : body.prescribed) object["prescribed"].push_back(motion(m));
    if (const auto* file = std::get_if<std::string>(&body.initial_velocity)) {
      object["initial_velocity"] = path(*file);
    } else {
      object["initial_velocity"] = vector(std::get<Eigen::Vector3d>(body.initial_velocity));
    }
    if (!body.surface.empty()) object["surface"] = path(body.surface);
    return object;
  }

  OrderedJson motion(const PrescribedMotion& motion) const {
    OrderedJson object = OrderedJson::object();
    if (motion.select) object["select"] = selection(*motion.select);
    if (!motion.targets.empty()) {
      object["targets"] = path(motion.targets);
    } else {
      object["translate"] = vector(motion.translate);
      object["rotate_deg"] = {
          {"axis", vector(motion.axis)}, {"angle", number(motion.angle_deg)}, {"center", vector(motion.center)}};
      object["scale"] = number(motion.scale);
    }
    object["start"] = number(motion.start);
    object["duration"] = number(motion.duration);
    return object;
  }

  static OrderedJson grab(const ScriptedGrab& grab) {
    OrderedJson object = OrderedJson::object();
    if (const auto* at = std::get_if<Eigen::Vector3d>(&grab.where))
      object["at"] = vector(*at);
    else
      object["select"] = selection(std::get<Selection>(grab.where));
    if (!grab.body.empty()) object["body"] = grab.body;
    if (grab.radius) object["radius"] = number(*grab.radius);
    if (grab.stiffness) object["stiffness"] = number(*grab.stiffness);
    object["start"] = number(grab.start);
    if (!grab.path.empty()) {
      for (const auto& [time, d] : grab.path)
        object["path"].push_back(OrderedJson::array({number(time), number(d.x()), number(d.y()), number(d.z())}));
    } else {
      if (grab.push)
        object["push"] = number(*grab.push);
      else
        object["translate"] = vector(grab.translate);
      object["duration"] = number(grab.duration);
    }
    if (grab.release) object["release"] = number(*grab.release);
    object["smooth"] = grab.smooth;
    return object;
  }

  static OrderedJson camera_key(const CameraKey& key) {
    OrderedJson object = {{"time", number(key.time)}};
    const auto add = [&](const char* name, const auto& value) {
      if (value) object[name] = setting(*value);
    };
    add("eye", key.eye);
    add("orbit_deg", key.orbit_deg);
    add("elevation_deg", key.elevation_deg);
    add("zoom", key.zoom);
    add("target", key.target);
    add("fov_deg", key.fov_deg);
    return object;
  }

  std::string path(const std::string& written) const { return path_from(folder_, scene_, written); }

  const Scene& scene_;
  fs::path folder_;
};

bool has_objects(const OrderedJson& list) {
  for (const OrderedJson& element : list) {
    if (element.is_object() || (element.is_array() && has_objects(element))) return true;
  }
  return false;
}

std::string text_of(const OrderedJson& value, const std::string& indent, bool on_one_line) {
  if (value.is_primitive() || value.empty()) return value.dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
  if (!on_one_line) {
    constexpr std::size_t kLongestLine = 100;
    std::string line = text_of(value, "", true);
    if (indent.size() + line.size() <= kLongestLine || (value.is_array() && !has_objects(value))) return line;
  }
  const std::string deeper = on_one_line ? "" : indent + "  ";
  std::string text;
  for (const auto& item : value.items()) {
    if (!text.empty()) text += on_one_line ? ", " : ",\n";
    text += deeper;
    if (value.is_object()) text += text_of(item.key(), "", true) + ": ";
    text += text_of(item.value(), deeper, on_one_line);
  }
  if (!on_one_line) text = "\n" + text + "\n" + indent;
  return value.is_object() ? "{" + text + "}" : "[" + text + "]";
}

}  // namespace

void move_scene(Scene& scene, const fs::path& file) {
  const Scene before = scene;
  const auto follow = [&](std::string& path, const std::string&) {
    path = path_from(file.parent_path(), before, path);
  };
  for_each_path(scene, follow);
  for (KnownFile& known : scene.files) follow(known.path, {});
  scene.file = file;
}

OrderedJson scene_document(const Scene& scene, const fs::path& folder) { return SceneWriter(scene, folder).write(); }

OrderedJson complete_document(const Scene& scene, const fs::path& folder) {
  const SceneWriter writer(scene, folder);
  OrderedJson document = writer.write();
  if (!scene.files.empty()) document["files"] = writer.files();
  return document;
}

OrderedJson solver_document(const SolverSettings& settings) {
  OrderedJson solver = {{"method", name_of(settings.method)},
                        {"acceleration", name_of(settings.acceleration)},
                        {"integrator", name_of(settings.integrator)}};
  visit_settings(settings, [&](const auto& field, const char* name, auto&&...) { solver[name] = number(field); });
  return solver;
}

OrderedJson material_document(const Material& values) { return material(values); }

OrderedJson camera_document(const CameraSettings& camera) {
  return {{"eye", vector(camera.eye)},
          {"target", vector(camera.target)},
          {"up", vector(camera.up)},
          {"fov_deg", number(camera.fov_deg)}};
}

OrderedJson display_document(const DisplaySettings& settings) { return display(settings); }

std::string text_of(const OrderedJson& document) { return text_of(document, "", false) + "\n"; }

std::string scene_to_json(const Scene& scene, const fs::path& folder) {
  return text_of(complete_document(scene, folder));
}

std::string parameters_to_json(const Scene& scene, const fs::path& folder) {
  return text_of(scene_document(scene, folder));
}

}  // namespace fascia
