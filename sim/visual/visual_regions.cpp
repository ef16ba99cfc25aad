#include "sim/visual/visual_regions.h"

#include <algorithm>
#include <map>

#include "sim/mesh/linear_tets.h"

namespace fascia {
namespace {

template <std::size_t n>
std::array<std::uint32_t, n> ascending(std::array<std::uint32_t, n> vertices) {
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

// The body and the region number of each tet; file_mesh holds the tets of all bodies one after the other.
std::vector<std::pair<std::uint32_t, int>> keys_of(const Model& model) {
  std::vector<std::pair<std::uint32_t, int>> keys;
  for (std::uint32_t b = 0; b < model.bodies.size(); ++b)
    for (std::uint32_t t = model.bodies[b].tet_begin; t < model.bodies[b].tet_begin + model.bodies[b].tet_count; ++t) {
      const std::uint32_t source = model.tet_source[t];
      keys.emplace_back(b, source < model.file_mesh.regions.size() ? model.file_mesh.regions[source] : 0);
    }
  return keys;
}

void number_triangles(const Model& model, const std::vector<std::uint32_t>& of_model_tet, const VisualSurface& surface,
                      VisualRegions& regions) {
  const auto vertex_count = static_cast<std::uint32_t>(model.rest_positions.size());
  std::map<Triangle, std::vector<std::size_t>> faces;
  std::map<Tet, std::vector<std::size_t>> holders;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    const Triangle& triangle = surface.triangles[i];
    if (triangle[0] < vertex_count)
      faces[ascending(triangle)].push_back(i);
    else
      holders[ascending(model.embedded.ties[triangle[0] - vertex_count].vertices)].push_back(i);
  }
  regions.of_triangle.assign(surface.triangles.size(), 0);
  const auto take = [&](const auto& table, const auto& key, std::uint32_t region) {
    if (const auto found = table.find(key); found != table.end())
      for (const std::size_t i : found->second) regions.of_triangle[i] = region;
  };
  for (std::size_t t = 0; t < regions.tets.size(); ++t) {
    const Tet tet = ascending(regions.tets[t]);
    for (std::size_t out = 0; out < 4; ++out) {
      Triangle face;
      for (std::size_t k = 0, n = 0; k < 4; ++k)
        if (k != out) face[n++] = tet[k];
      take(faces, face, regions.of_tet[t]);
    }
  }
  if (holders.empty()) return;
  for (std::size_t t = 0; t < model.tets.size(); ++t) take(holders, ascending(model.tets[t]), of_model_tet[t]);
}

}  // namespace

VisualRegions drawn_regions(const Scene& scene, const Model& model, const VisualSurface& surface) {
  VisualRegions regions;
  const auto keys = keys_of(model);
  std::map<std::pair<std::uint32_t, int>, std::uint32_t> numbers;
  for (const auto& key : keys) numbers[key] = 0;
  for (auto& [key, number] : numbers) {
    number = static_cast<std::uint32_t>(regions.names.size());
    const std::map<int, std::string>& known = model.bodies[key.first].regions;
    const auto name = known.find(key.second);
    const std::string own =
        name != known.end() && !name->second.empty() ? name->second : "region " + std::to_string(key.second);
    regions.names.push_back(scene.bodies.size() > 1 ? model.bodies[key.first].name + ": " + own : own);
  }
  std::vector<std::uint32_t> of_model_tet;
  for (const auto& key : keys) of_model_tet.push_back(numbers[key]);
  regions.first_tet.resize(regions.names.size());
  for (std::size_t t = keys.size(); t-- > 0;) regions.first_tet[of_model_tet[t]] = static_cast<std::uint32_t>(t);
  LinearTets linear = linear_tets(model.tets, model.mid_edges, model.rest_positions, 0, model.tets.size());
  for (const std::uint32_t t : linear.source) regions.of_tet.push_back(of_model_tet[t]);
  regions.tets = std::move(linear.tets);
  number_triangles(model, of_model_tet, surface, regions);
  return regions;
}

}  // namespace fascia
