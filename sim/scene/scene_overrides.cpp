#include "sim/scene/scene_overrides.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <optional>

#include "base/error.h"
#include "base/json/json_document.h"
#include "base/json/json_option.h"
#include "base/suggest.h"
#include "sim/material/tissue_looks.h"
#include "sim/scene/grab_text.h"
#include "sim/scene/scene.h"
#include "sim/scene/tools/instrument_text.h"
#include "sim/surface/surface_fill.h"

namespace fascia {
namespace {

using nlohmann::json;

std::optional<std::size_t> index_of(const std::string& segment) {
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(segment.data(), segment.data() + segment.size(), index);
  if (error != std::errc() || end != segment.data() + segment.size()) return std::nullopt;
  return index;
}

/// A scene with every default written out: shows which keys hold lists, and the value of a vector before one of its
/// elements is set.
const json& template_document() {
  static const json document = [] {
    Scene scene;
    scene.camera.emplace();
    scene.camera_motion.keys = {{0, Eigen::Vector3d::Ones(), 0, 0, 1, Eigen::Vector3d::Zero(), 40}};
    scene.display.section.emplace();
    scene.display.tets.emplace();
    Body& body = scene.bodies.emplace_back();
    body.regions = {{"region", {{0, 1}}}};
    body.fixed.emplace_back(LowestSelection{0.02});
    body.prescribed.emplace_back().select = LowestSelection{0.02};
    body.surface = "surface.obj";
    body.material.look = &tissue_looks().front();
    body.material.color = {0, 0, 0};
    scene.grabs.emplace_back().radius = 0.01;
    scene.tools.ground.emplace().friction = 0.5;
    scene.tools.obstacles.emplace_back().friction = 0.5;
    Instrument& instrument = scene.tools.instruments.emplace_back();
    instrument.friction = 0.5;
    instrument.path.emplace_back();
    body.resolution = kFewestCells;
    body.elements = ElementOrder::quadratic;
    body.unit = LengthUnit::mm;
    body.up = UpAxis::z;
    return parse_json(scene_to_json(scene, ""), "template");
  }();
  return document;
}

/// The keys of an object, and with `path` those of the objects in it: "solver.iterations".
void collect_keys(const json& object, const std::string& path, std::vector<std::string>& keys) {
  for (const auto& item : object.items()) {
    keys.push_back(path + item.key());
    if (!path.empty() && item.value().is_object()) collect_keys(item.value(), path + item.key() + ".", keys);
  }
}

/// The known key nearest to a first segment: of a scene, of a body, or of an object in them, which is then named with
/// its path.
std::string near_key(const std::string& segment, const std::vector<std::string>& first_keys) {
  const json &scene = template_document(), &body = scene["bodies"][0];
  std::vector<std::string> paths = first_keys, names;
  for (const char* section : {"solver", "display", "camera"})
    collect_keys(scene[section], std::string(section) + ".", paths);
  collect_keys(body["materials"]["default"], "materials.default.", paths);
  collect_keys(body["transform"], "transform.", paths);
  for (const std::string& path : paths) names.push_back(path.substr(path.rfind('.') + 1));  // npos + 1 is 0
  const std::string near = nearest(segment, names);
  return near.empty() ? ""
                      : paths[static_cast<std::size_t>(std::find(names.begin(), names.end(), near) - names.begin())];
}

/// Suggests the keys of bodies, which may also begin a KEY: the reader of the scene sees them at its top level only and
/// would not suggest them.
void require_known(const json& document, const std::string& key, const std::string& segment) {
  if (!document.is_object() || document.contains(segment) || template_document().contains(segment)) return;
  std::vector<std::string> known;
  collect_keys(template_document(), "", known);
  collect_keys(template_document()["bodies"][0], "", known);
  const std::string near = near_key(segment, known);
  throw Error(option_of(key), "unknown key " + excerpt(segment) + (near.empty() ? "" : ", perhaps \"" + near + "\""),
              "expected one of " + join(known));
}

const json* child(const json* parent, const std::string& segment) {
  if (!parent) return nullptr;
  if (parent->is_array()) return parent->empty() ? nullptr : &parent->front();
  return parent->contains(segment) ? &(*parent)[segment] : nullptr;
}

/// The value that must be created for `next` to be an element of it.
json container_for(const json* pattern, const std::string& next) {
  if (pattern && pattern->is_array()) return pattern->front().is_number() ? *pattern : json::array();
  if (pattern && pattern->is_object()) return json::object();
  return index_of(next) ? json::array() : json::object();
}

void apply(json& document, const std::string& key, const std::vector<std::string>& segments, json value,
           DocumentOrigin& origin) {
  const std::string where = option_of(key);
  json* node = &document;
  const json* pattern = &template_document();
  std::string path, touched;
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const std::string& segment = segments[s];
    const bool is_last = s + 1 == segments.size();
    pattern = child(pattern, segment);
    bool is_new = false;
    if (node->is_object()) {
      path = path_of_key(path, segment);
      is_new = !node->contains(segment);
      if (is_new && !is_last) (*node)[segment] = container_for(pattern, segments[s + 1]);
      node = &(*node)[segment];
    } else if (node->is_array()) {
      const auto index = index_of(segment);
      if (!index || *index > node->size()) {
        throw Error(where,
                    excerpt(segment) + " is not an element of " + path + ", which has " + std::to_string(node->size()),
                    "expected 0 to " + std::to_string(node->size()) + " (the end: a new element)");
      }
      path = path_of_element(path, *index);
      is_new = *index == node->size();
      if (is_new) node->push_back(is_last ? json() : container_for(pattern, segments[s + 1]));
      node = &(*node)[*index];
    } else {
      throw Error(where, path + " is " + excerpt(*node), "expected no key below it");
    }
    if (touched.empty() && (is_new || is_last)) touched = path;
  }
  *node = std::move(value);
  origin.overrides.push_back({key, path, touched});
}

/// A preset from the command line replaces the numbers that the file gives the material; those from the command line
/// stay.
void clear_preset_values(json& document, const std::vector<std::string>& segments, const DocumentOrigin& origin) {
  if (segments.size() < 4 || segments.back() != "preset" || segments[segments.size() - 3] != "materials") return;
  json* material = &document;
  for (std::size_t s = 0; s + 1 < segments.size(); ++s)
    material = &(material->is_array() ? (*material)[*index_of(segments[s])] : (*material)[segments[s]]);
  const std::string& path = origin.overrides.back().path;
  const std::string parent = path.substr(0, path.rfind('.'));
  for (const char* key : {"young_modulus", "poisson_ratio", "density", "look"}) {
    const bool asked =
        std::any_of(origin.overrides.begin(), origin.overrides.end(),
                    [&](const DocumentOrigin::Override& o) { return o.path == path_of_key(parent, key); });
    if (!asked) material->erase(key);
  }
}

/// "--grab TEXT", "--instrument TEXT": appends an element to a list of the scene.
void append_to(json& document, const char* list, const char* option, json element, DocumentOrigin& origin) {
  const std::size_t count = document.is_object() && document.contains(list) ? document[list].size() : 0;
  apply(document, option, {list, std::to_string(count)}, std::move(element), origin);
}

json value_of(const std::string& text) {
  try {
    return parse_json(text, "");
  } catch (const Error&) {
    if (const std::optional<double> number = number_in(text)) return *number;
    return text;
  }
}

}  // namespace

std::vector<std::string> segments_of(const std::string& key) {
  std::vector<std::string> segments(1);
  for (const char c : key) {
    if (c == '.' || c == '[') {
      segments.emplace_back();
    } else if (c != ']') {
      segments.back() += c;
    }
  }
  for (const std::string& segment : segments) {
    if (segment.empty()) return {};
  }
  if (template_document()["bodies"][0].contains(segments.front())) segments.insert(segments.begin(), {"bodies", "0"});
  return segments;
}

void apply_overrides(json& document, const std::vector<std::string>& overrides, DocumentOrigin& origin) {
  constexpr std::string_view kGrab = "--grab ", kInstrument = "--instrument ";
  for (const std::string& text : overrides) {
    if (text.starts_with(kGrab)) {
      append_to(document, "grabs", "--grab", grab_document(std::string_view(text).substr(kGrab.size())), origin);
      continue;
    }
    if (text.starts_with(kInstrument)) {
      append_to(document, "instruments", "--instrument",
                instrument_document(std::string_view(text).substr(kInstrument.size())), origin);
      continue;
    }
    const std::size_t equals = std::min(text.find('='), text.size());
    const std::string key = text.substr(0, equals);
    const std::vector<std::string> segments = segments_of(key);
    if (equals == text.size() || segments.empty()) {
      throw Error("--set " + on_one_line(text), equals == text.size() ? "has no =" : "has no key",
                  "expected KEY=VALUE such as solver.iterations=40");
    }
    if (segments.size() > kDeepestNesting) {
      throw Error("--set " + on_one_line(key), "leads deeper than " + std::to_string(kDeepestNesting) + " levels",
                  "expected a key of a scene");
    }
    require_known(document, key, segments.front());
    apply(document, key, segments, value_of(text.substr(equals + 1)), origin);
    clear_preset_values(document, segments, origin);
  }
}

}  // namespace fascia
