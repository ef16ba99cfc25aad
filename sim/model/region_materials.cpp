#include "sim/model/region_materials.h"

#include <charconv>
#include <optional>

#include "base/error.h"
#include "base/suggest.h"

namespace fascia {

Material with_override(Material material, const MaterialOverride& values) {
  // Both tables list the same fields in the same order.
  std::vector<std::optional<double>> given;
  visit_material(values, [&](const auto& field, auto&&...) { given.push_back(field); });
  std::size_t next = 0;
  visit_material(material, [&](double& field, auto&&...) { field = given[next++].value_or(field); });
  material.model = values.model.value_or(material.model);
  if (values.look) material.look = values.look;
  if (values.color) material.color = values.color;
  return material;
}

MaterialOverride override_with(const Material& material) {
  std::vector<double> numbers;
  visit_material(material, [&](double number, auto&&...) { numbers.push_back(number); });
  MaterialOverride values;
  std::size_t next = 0;
  visit_material(values, [&](auto& field, auto&&...) { field = numbers[next++]; });
  values.model = material.model;
  values.look = material.look;
  values.color = material.color;
  return values;
}

namespace {

std::optional<int> number_of(const std::string& key) {
  int number = 0;
  const auto [end, error] = std::from_chars(key.data(), key.data() + key.size(), number);
  if (error != std::errc() || end != key.data() + key.size()) return std::nullopt;
  return number;
}

/// The regions that a key names: those with that name, else the one with that number.
std::vector<int> named(const std::string& key, const std::map<int, std::string>& regions) {
  std::vector<int> found;
  for (const auto& [number, name] : regions) {
    if (!name.empty() && name == key) found.push_back(number);
  }
  const auto number = number_of(key);
  if (found.empty() && number && regions.count(*number)) found.push_back(*number);
  return found;
}

[[noreturn]] void fail_unknown(const std::string& key, const std::map<int, std::string>& regions,
                               const std::string& where) {
  std::vector<std::string> names{"default"}, listed;
  for (const auto& [number, name] : regions) {
    if (!name.empty()) names.push_back(name);
    listed.push_back(std::to_string(number) + (name.empty() ? "" : " (" + name + ")"));
  }
  throw Error(where, "the mesh has no region \"" + key + "\"" + perhaps(key, names),
              "expected default or one of its regions: " + join(listed));
}

}  // namespace

std::map<int, std::string> regions_of(const TetMesh& mesh) {
  std::map<int, std::string> regions;
  for (const int number : mesh.regions) regions.try_emplace(number);
  for (auto& [number, name] : regions) {
    const auto found = mesh.region_names.find(number);
    if (found != mesh.region_names.end()) name = found->second;
  }
  return regions;
}

std::string key_of_region(const std::map<int, std::string>& regions, int number) {
  const auto found = regions.find(number);
  if (found == regions.end() || found->second.empty() || found->second == "default") return std::to_string(number);
  return named(found->second, regions).size() == 1 ? found->second : std::to_string(number);
}

void assign_regions(const Body& body, const std::map<int, std::string>& taken, const std::string& where,
                    TetMesh& mesh) {
  std::map<int, std::string> regions = mesh.region_names;
  regions.merge(regions_of(mesh));
  const auto number_for = [&](const std::string& name) {
    if (const std::vector<int> known = named(name, regions); !known.empty()) return known.front();
    int number = 1;
    if (const auto given = number_of(name)) {
      number = *given;
      regions.emplace(number, "");
    } else {
      const auto of_other = [&] { return taken.contains(number) && taken.at(number) != name; };
      while (regions.contains(number) || of_other()) ++number;
      regions.emplace(number, name);
      mesh.region_names[number] = name;
    }
    return number;
  };
  constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  std::vector<std::size_t> entry_of(body.regions.empty() ? 0 : mesh.tets.size(), kNone);
  for (std::size_t r = 0; r < body.regions.size(); ++r) {
    const TetRegion& region = body.regions[r];
    const std::string path = where + ".regions[" + std::to_string(r) + "].tets";
    if (const std::uint32_t last = region.tets.back().last; last >= mesh.tets.size())
      throw Error(path, "tet " + std::to_string(last) + " does not exist",
                  "expected 0 to " + std::to_string(mesh.tets.size() - 1));
    const int number = number_for(region.name);
    for (const TetRange& range : region.tets)
      for (std::uint32_t t = range.first; t <= range.last; ++t) {
        if (entry_of[t] != kNone)
          throw Error(path, "has tet " + std::to_string(t) + ", as regions[" + std::to_string(entry_of[t]) + "] does",
                      "expected each tet in one region");
        entry_of[t] = r;
        mesh.regions[t] = number;
      }
  }
}

BodyMaterials resolve_materials(const Body& body, const std::map<int, std::string>& present, const std::string& where) {
  BodyMaterials result;
  result.materials.push_back(body.material);
  result.names.push_back(body.name + ": default");
  for (const auto& [key, values] : body.region_materials) {
    const std::string path = where + ".materials." + key;
    const std::vector<int> regions = named(key, present);
    if (regions.empty()) fail_unknown(key, present, path);
    const auto index = static_cast<std::uint32_t>(result.materials.size());
    for (const int region : regions) {
      const auto [earlier, is_new] = result.of_region.emplace(region, index);
      if (is_new) continue;
      throw Error(path,
                  "means region " + std::to_string(region) + ", as materials." +
                      body.region_materials[earlier->second - 1].first + " does",
                  "expected one entry per region");
    }
    result.materials.push_back(with_override(body.material, values));
    result.names.push_back(body.name + ": " + key);
  }
  return result;
}

void assign_materials(const Scene& scene, Model& model) {
  std::vector<Material> materials;
  std::vector<std::string> names;
  std::vector<std::uint32_t> tet_material = model.tet_material;
  std::vector<BodyPart> bodies = model.bodies;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    BodyPart& part = bodies[b];
    const BodyMaterials resolved =
        resolve_materials(scene.bodies[b], part.regions, scene.file.string() + ": bodies[" + std::to_string(b) + "]");
    part.material_begin = static_cast<std::uint32_t>(materials.size());
    part.material_count = static_cast<std::uint32_t>(resolved.materials.size());
    for (std::uint32_t t = part.tet_begin; t < part.tet_begin + part.tet_count; ++t)
      tet_material[t] = part.material_begin + resolved.material_of(model.file_mesh.regions[model.tet_source[t]]);
    materials.insert(materials.end(), resolved.materials.begin(), resolved.materials.end());
    names.insert(names.end(), resolved.names.begin(), resolved.names.end());
  }
  model.materials = std::move(materials);
  model.material_names = std::move(names);
  model.tet_material = std::move(tet_material);
  model.bodies = std::move(bodies);
}

}  // namespace fascia
