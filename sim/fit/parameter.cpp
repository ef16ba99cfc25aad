#include "sim/fit/parameter.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/suggest.h"
#include "base/text.h"
#include "sim/fit/tuned_scene.h"
#include "sim/scene/scene_overrides.h"
#include "sim/scene/scene_write.h"

namespace fascia {
namespace {

using Json = nlohmann::ordered_json;

const Json* find(const Json& document, const std::vector<std::string>& segments) {
  const Json* node = &document;
  for (const std::string& segment : segments) {
    if (node->is_array()) {
      std::size_t index = 0;
      const char* const end = segment.data() + segment.size();
      if (std::from_chars(segment.data(), end, index).ptr != end || index >= node->size()) return nullptr;
      node = &(*node)[index];
    } else if (node->is_object() && node->contains(segment)) {
      node = &(*node)[segment];
    } else {
      return nullptr;
    }
  }
  return node;
}

// A region has the values of "default" that it does not replace.
const Json* find_in_default(const Json& document, std::vector<std::string> segments) {
  if (segments.size() != 5 || segments[2] != "materials") return nullptr;
  segments[3] = "default";
  return find(document, segments);
}

double value_in(const Scene& scene, const std::string& key) {
  const std::string where = "--free " + key;
  const Json document = scene_document(scene, scene.file.parent_path());
  const std::vector<std::string> segments = segments_of(key);
  if (segments.empty()) throw Error(where, "has no key", "expected a number of the scene, as for --set");
  const Json* node = find(document, segments);
  if (!node) node = find_in_default(document, segments);
  if (node && node->is_number()) return node->get<double>();
  if (node) throw Error(where, "is no number of the scene", "expected one such as materials.default.young_modulus");
  with_values(scene, {{key, 1}});  // the reader knows the nearest key
  throw Error(where, "has no value in the scene", "expected --set " + key + "=VALUE to start from");
}

// Ratios are bounded and linear; all that is positive is fitted by its logarithm.
void choose_scale(Parameter& parameter) {
  const std::string field = parameter.key.substr(parameter.key.rfind('.') + 1);
  parameter.logarithmic = parameter.start > 0;
  const Material usual;
  visit_material(usual, [&](double, const char* name, const char* unit, double low, double high, bool, const char*) {
    if (field != name || *unit != '\0') return;
    parameter.logarithmic = false;
    parameter.bounds = {low, high};
  });
}

struct Pair {
  Parameter& parameter;
  double first, second;
};

Pair parsed(std::vector<Parameter>& parameters, const std::string& option, const std::string& text,
            const std::string& form) {
  const std::size_t equals = std::min(text.find('='), text.size()),
                    colon = std::min(text.find(':', equals), text.size());
  const std::string key = text.substr(0, equals);
  const auto found =
      std::find_if(parameters.begin(), parameters.end(), [&](const Parameter& p) { return p.key == key; });
  std::vector<std::string> keys;
  for (const Parameter& parameter : parameters) keys.push_back(parameter.key);
  if (found == parameters.end())
    throw Error(option + " " + text, "names no free parameter" + perhaps(key, keys), "expected one of " + join(keys));
  const auto number_in = [&](std::size_t begin, std::size_t end) {
    double value = 0;
    const char *const from = text.data() + std::min(begin, end), *const to = text.data() + end;
    const auto [stop, problem] = std::from_chars(from, to, value);
    if (problem != std::errc() || stop != to || !std::isfinite(value))
      throw Error(option + " " + text, "is not " + form, "expected two numbers");
    return value;
  };
  const double first = number_in(equals + 1, colon);
  return {*found, first, number_in(colon + 1, text.size())};
}

}  // namespace

double Parameter::natural(double value) const { return logarithmic ? std::log(value) : value; }
double Parameter::from_natural(double natural) const { return logarithmic ? std::exp(natural) : natural; }

double Parameter::inner(double value) const {
  const double n = natural(value);
  if (!bounds) return n;
  const double low = natural(bounds->low), high = natural(bounds->high);
  constexpr double kInside = 1e-9;  // of the range: a start at a bound
  const double share = std::clamp((n - low) / (high - low), kInside, 1 - kInside);
  return std::log(share / (1 - share));
}

double Parameter::value(double inner) const {
  if (!bounds) return from_natural(inner);
  const double low = natural(bounds->low), high = natural(bounds->high);
  return from_natural(low + (high - low) / (1 + std::exp(-inner)));
}

double Parameter::natural_rate(double inner) const {
  if (!bounds) return 1;
  const double share = 1 / (1 + std::exp(-inner));
  return (natural(bounds->high) - natural(bounds->low)) * share * (1 - share);
}

double Parameter::prior_distance(double inner) const {
  if (!prior) return 0;
  const double spread = logarithmic ? prior->spread / prior->mean : prior->spread;
  return (natural(value(inner)) - natural(prior->mean)) / spread;
}

double Parameter::prior_rate(double inner) const {
  if (!prior) return 0;
  return natural_rate(inner) * (logarithmic ? prior->mean / prior->spread : 1 / prior->spread);
}

std::vector<Parameter> parameters_of(const Scene& scene, const std::vector<std::string>& keys) {
  std::vector<Parameter> parameters;
  for (const std::string& key : keys) {
    if (std::find(keys.begin(), keys.end(), key) != keys.begin() + static_cast<long>(parameters.size()))
      throw Error("--free " + key, "is given twice", "expected every key once");
    Parameter& parameter = parameters.emplace_back();
    parameter.key = key;
    parameter.start = value_in(scene, key);
    choose_scale(parameter);
  }
  return parameters;
}

void set_bounds(std::vector<Parameter>& parameters, const std::string& text) {
  const auto [parameter, low, high] = parsed(parameters, "--bounds", text, "KEY=LOW:HIGH");
  if (!(low < high)) throw Error("--bounds " + text, "is an empty range", "expected KEY=LOW:HIGH");
  if (parameter.bounds && (low < parameter.bounds->low || high > parameter.bounds->high))
    throw Error("--bounds " + text, "leaves the range of scenes",
                "expected " + number(parameter.bounds->low) + " to " + number(parameter.bounds->high));
  if (!(low <= parameter.start && parameter.start <= high))
    throw Error("--bounds " + text, "excludes the scene's value " + number(parameter.start),
                "expected a range around it, or --set " + parameter.key + "=VALUE");
  parameter.logarithmic = parameter.logarithmic && low > 0;
  parameter.bounds = {low, high};
}

void set_prior(std::vector<Parameter>& parameters, const std::string& text) {
  const auto [parameter, mean, spread] = parsed(parameters, "--prior", text, "KEY=MEAN:SPREAD");
  if (!(spread > 0) || (parameter.logarithmic && !(mean > 0)))
    throw Error("--prior " + text, "is no distribution of a positive number", "expected KEY=MEAN:SPREAD");
  parameter.prior = {mean, spread};
}

}  // namespace fascia
