#include "sim/fit/tuned_scene.h"

#include <algorithm>

#include "base/error.h"
#include "base/number_text.h"
#include "sim/grab/build_model.h"
#include "sim/grab/resolve_grab.h"
#include "sim/model/region_materials.h"
#include "sim/scene/scene_overrides.h"

namespace fascia {

Scene with_values(const Scene& scene, const std::vector<std::pair<std::string, double>>& values) {
  std::vector<std::string> overrides;
  for (const auto& [key, value] : values) overrides.push_back(NumberText().add(key).add('=').add(value).take());
  try {
    Scene result = read_scene_content(scene.file, scene_to_json(scene, scene.file.parent_path()), overrides);
    result.option_grabs = scene.option_grabs;
    return result;
  } catch (const Error& error) {
    constexpr std::string_view kSet = "--set ";
    const std::string text = error.what();
    if (!text.starts_with(kSet)) throw;
    throw Error("--free " + text.substr(kSet.size()));
  }
}

TunedScene::TunedScene(Scene scene, Model model, std::vector<Parameter> parameters)
    : scene_(std::move(scene)), model_(std::move(model)), parameters_(std::move(parameters)) {
  for (const Parameter& parameter : parameters_) {
    const std::vector<std::string> segments = segments_of(parameter.key);
    const auto begins = [&](const char* name, std::size_t at) { return segments.size() > at && segments[at] == name; };
    if (begins("camera", 0) || begins("display", 0) || begins("duration", 0) || begins("solver", 0))
      throw Error("--free " + parameter.key, "changes no tissue and no load",
                  "expected a number such as materials.default.young_modulus");
    const bool material = begins("bodies", 0) && begins("materials", 2);
    const bool load = begins("gravity", 0) || begins("grabs", 0) || (begins("bodies", 0) && begins("prescribed", 2));
    kinds_.push_back(material ? Kind::material : load ? Kind::load : Kind::other);
  }
  at(start());
}

std::vector<double> TunedScene::start() const {
  std::vector<double> inner;
  for (const Parameter& parameter : parameters_) inner.push_back(parameter.inner(parameter.start));
  return inner;
}

TunedScene::Built TunedScene::at(const std::vector<double>& inner) const {
  std::vector<std::pair<std::string, double>> values;
  for (std::size_t p = 0; p < inner.size(); ++p)
    values.emplace_back(parameters_[p].key, parameters_[p].value(inner[p]));
  Built built{with_values(scene_, values), {}};
  if (std::any_of(kinds_.begin(), kinds_.end(), [](Kind kind) { return kind != Kind::material; })) {
    built.model = build_model(built.scene);
    return built;
  }
  built.model = model_;
  assign_materials(built.scene, built.model);
  // The stiffness of a grab follows the tissue where the scene does not say it.
  for (std::size_t g = 0; g < built.scene.grabs.size(); ++g)
    built.model.grabs[g] = resolve_grab(built.scene, g, built.model);
  return built;
}

}  // namespace fascia
