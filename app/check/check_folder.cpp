#include "app/check/check_folder.h"

#include <algorithm>
#include <map>
#include <optional>

#include "app/golden/tolerance.h"
#include "base/error.h"
#include "base/file.h"
#include "base/json/json_document.h"
#include "base/json/json_node.h"
#include "render/supersampler.h"

namespace fascia {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSettingsName = "check.json";

struct CheckSettings {
  RenderOptions options;
  bool picture = true, state = true;
};

const std::vector<std::string>& setting_keys() {
  static const std::vector<std::string> keys{"size",
                                             "samples",
                                             "steps",
                                             "time",
                                             "static",
                                             "set",
                                             "ui",
                                             "max_mean",
                                             "max_share",
                                             "state_tolerance",
                                             "contact_tolerance",
                                             "picture",
                                             "state"};
  return keys;
}

void read_tolerance(const Node& node, const std::string& key, double& field) {
  const std::optional<Node> value = node.find(key);
  if (!value) return;
  field = value->is_string() ? parse_tolerance(value->text("a share"), node.where(key)) : value->number(0, 1, "");
}

void read_flag(const Node& node, const std::string& key, bool& field) {
  if (const std::optional<Node> value = node.find(key)) field = value->boolean();
}

void read_settings(const Node& node, CheckSettings& settings) {
  RenderOptions& options = settings.options;
  if (const auto size = node.find("size")) {
    const std::vector<Node> sides = size->elements("a list of 2 numbers, width and height");
    if (sides.size() != 2) size->refuse("a list of 2 numbers, width and height");
    options.width = sides[0].integer(16, 16384);
    options.height = sides[1].integer(16, 16384);
  }
  node.read("samples", options.samples, 1, kMostSamples);
  const auto steps = node.find("steps"), time = node.find("time");
  if (steps && time) time->fail("steps are given, too", "one of them");
  if (steps) options.time.reset(), options.steps = steps->integer(0, 1000000000);
  if (time) options.steps.reset(), options.time = time->number(0, 1e9, "s");
  read_flag(node, "static", options.static_equilibrium);
  read_flag(node, "ui", options.panels);
  if (const auto set = node.find("set")) {
    options.sets.clear();
    for (const Node& text : set->elements("a list of texts KEY=VALUE"))
      options.sets.push_back(text.text("a text KEY=VALUE"));
  }
  read_tolerance(node, "max_mean", options.limits.mean);
  read_tolerance(node, "max_share", options.limits.share);
  read_tolerance(node, "state_tolerance", options.limits.state);
  read_tolerance(node, "contact_tolerance", options.limits.contact);
  read_flag(node, "picture", settings.picture);
  read_flag(node, "state", settings.state);
  if (!settings.picture && !settings.state) node.fail("compares neither picture nor state", "one of them");
}

void require_file_name(const Node& node, const std::string& name) {
  if (name.empty() || name[0] == '.' || name.find('/') != std::string::npos)
    node.fail("its name names goldens", "a file name without folder, not beginning with a dot");
}

// NAME -> file, for the scenes and replays in the folder.
std::map<std::string, fs::path> files_of(const fs::path& folder) {
  std::map<std::string, fs::path> files;
  std::error_code ec;
  fs::directory_iterator entry(folder, ec);
  if (ec)
    throw Error(folder.string(), "cannot be listed: " + ec.message(),
                "expected a folder of scenes (.json) and replays (.fascia)");
  for (; entry != fs::directory_iterator(); entry.increment(ec)) {
    const fs::path& file = entry->path();
    const std::string ending = lower_ending(file);
    if ((ending != ".json" && ending != ".fascia") || file.filename() == kSettingsName ||
        file.filename().string()[0] == '.')
      continue;
    if (lower_ending(file.stem()) == ".csv") continue;  // provenance of an exported state
    const auto [other, added] = files.emplace(file.stem().string(), file);
    if (!added)
      throw Error(file.string(), "has the same goldens as " + other->second.filename().string(),
                  "expected another name");
  }
  return files;
}

}  // namespace

std::vector<CheckCase> read_check_folder(const fs::path& folder) {
  std::map<std::string, fs::path> files = files_of(folder);
  CheckSettings defaults;
  defaults.options.width = 320;
  defaults.options.height = 240;
  std::map<std::string, CheckSettings> cases;
  const fs::path file = folder / kSettingsName;
  if (std::error_code ec; fs::exists(file, ec)) {
    const nlohmann::json document = parse_json(read_file(file), file.string());
    const DocumentOrigin origin{file.string(), {}};
    const Node root(document, "", origin);
    root.expect_object({"fascia_check", "defaults", "scenes"});
    root.at("fascia_check", "the format's version, 1").integer(1, 1);
    if (const auto node = root.find("defaults")) {
      node->expect_object(setting_keys());
      read_settings(*node, defaults);
    }
    std::vector<std::string> keys = setting_keys();
    keys.push_back("scene");
    if (const auto scenes = root.find("scenes"))
      for (const auto& [name, node] : scenes->members("an object with an object for every scene")) {
        node.expect_object(keys);
        require_file_name(node, name);
        const auto input = node.find("scene");
        if (!input && !files.contains(name))
          node.fail("there is no " + name + ".json or .fascia", "such a file beside, or a key scene");
        if (input && files.contains(name))
          input->fail(files[name].filename().string() + " has the same goldens", "another name");
        if (input) files[name] = folder / input->text("a scene, mesh or replay, relative to this file");
        read_settings(node, cases.emplace(name, defaults).first->second);
      }
  }
  if (files.empty())
    throw Error(folder.string(), "has no scenes", "expected NAME.json, NAME.fascia, or scenes named in check.json");
  std::vector<CheckCase> result;
  for (const auto& [name, input] : files) {
    CheckSettings settings = cases.contains(name) ? cases[name] : defaults;
    settings.options.input = input.string();
    if (settings.picture) settings.options.compare = folder / (name + ".golden.png");
    if (settings.state) settings.options.state = folder / (name + ".golden.csv");
    result.push_back({name, std::move(settings.options)});
  }
  return result;
}

}  // namespace fascia
