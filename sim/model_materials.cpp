#include "sim/model_materials.h"

#include <charconv>
#include <optional>
#include <set>

#include "sim/error.h"
#include "sim/suggest.h"

namespace fascia {
namespace {

Material merged(Material material, const MaterialOverride& values) {
  // Both tables list the same fields in the same order.
  std::vector<std::optional<double>> given;
  visit_material(values, [&](const auto& field, auto&&...) { given.push_back(field); });
  std::size_t next = 0;
  visit_material(material, [&](double& field, auto&&...) { field = given[next++].value_or(field); });
  material.model = values.model.value_or(material.model);
  return material;
}

std::optional<int> number_of(const std::string& key) {
  int number = 0;
  const auto [end, error] = std::from_chars(key.data(), key.data() + key.size(), number);
  if (error != std::errc() || end != key.data() + key.size()) return std::nullopt;
  return number;
}

/// The regions of the mesh that a key names: those of that name, else the one of that number.
std::vector<int> regions_of(const std::string& key, const TetMesh& mesh, const std::set<int>& present) {
  std::vector<int> regions;
  for (const auto& [number, name] : mesh.region_names) {
    if (name == key && present.count(number)) regions.push_back(number);
  }
  const auto number = number_of(key);
  if (regions.empty() && number && present.count(*number)) regions.push_back(*number);
  return regions;
}

[[noreturn]] void fail_unknown(const std::string& key, const TetMesh& mesh, const std::set<int>& present,
                               const std::string& where) {
  std::vector<std::string> names, listed;
  for (const int number : present) {
    const auto name = mesh.region_names.find(number);
    const bool is_named = name != mesh.region_names.end() && !name->second.empty();
    if (is_named) names.push_back(name->second);
    listed.push_back(std::to_string(number) + (is_named ? " (" + name->second + ")" : ""));
  }
  throw Error(where, "the mesh has no region \"" + key + "\"" + perhaps(key, names),
              "expected default or one of its regions: " + join(listed));
}

}  // namespace

BodyMaterials resolve_materials(const Body& body, const TetMesh& mesh, const std::string& where) {
  const std::set<int> present(mesh.regions.begin(), mesh.regions.end());
  BodyMaterials result;
  result.materials.push_back(body.material);
  result.names.push_back(body.name + ": default");
  for (const auto& [key, values] : body.region_materials) {
    const std::string path = where + ".materials." + key;
    const std::vector<int> regions = regions_of(key, mesh, present);
    if (regions.empty()) fail_unknown(key, mesh, present, path);
    const auto index = static_cast<std::uint32_t>(result.materials.size());
    for (const int region : regions) {
      const auto [earlier, is_new] = result.of_region.emplace(region, index);
      if (is_new) continue;
      throw Error(path,
                  "means region " + std::to_string(region) + ", as materials." +
                      body.region_materials[earlier->second - 1].first + " does",
                  "expected one entry per region");
    }
    result.materials.push_back(merged(body.material, values));
    result.names.push_back(body.name + ": " + key);
  }
  return result;
}

}  // namespace fascia
