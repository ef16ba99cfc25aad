#include "app/state/painted_regions.h"

#include <algorithm>

#include "sim/model/region_materials.h"

namespace fascia {
namespace {

/// The tets of one body's mesh file, and the entries of "regions" that have them.
class PaintedBody {
 public:
  PaintedBody(const Model& model, std::size_t body, const std::vector<TetRegion>& regions)
      : model_(model), part_(model.bodies[body]), first_(first_tet(body)), painted_(first_tet(body + 1) - first_) {
    for (const TetRegion& region : regions) {
      for (const TetRange& range : region.tets)
        std::fill(painted_.begin() + range.first, painted_.begin() + range.last + 1, names_.size() + 1);
      names_.push_back(region.name);
    }
  }

  bool knows(const std::string& name) const {
    return std::any_of(part_.regions.begin(), part_.regions.end(),
                       [&](const auto& region) { return key_of_region(part_.regions, region.first) == name; });
  }

  void paint(std::span<const std::uint32_t> tets, const std::string& name) {
    const auto found = std::find(names_.begin(), names_.end(), name);
    const auto entry = static_cast<std::size_t>(found - names_.begin()) + 1;
    for (const std::uint32_t t : tets) {
      if (t < part_.tet_begin || t >= part_.tet_begin + part_.tet_count) continue;
      const std::uint32_t source = model_.tet_source[t];
      std::size_t& of_tet = painted_[source - first_];
      if (name.empty())
        of_tet = 0;
      else if (of_tet != 0 || key_of_region(part_.regions, model_.file_mesh.regions[source]) != name)
        of_tet = entry;
    }
    if (found == names_.end()) names_.push_back(name);
  }

  std::vector<TetRegion> regions() const {
    std::vector<TetRegion> regions;
    for (const std::string& name : names_) regions.push_back({name, {}});
    for (std::uint32_t t = 0; t < painted_.size(); ++t) {
      if (painted_[t] == 0) continue;
      std::vector<TetRange>& ranges = regions[painted_[t] - 1].tets;
      if (ranges.empty() || ranges.back().last + 1 != t)
        ranges.push_back({t, t});
      else
        ranges.back().last = t;
    }
    std::erase_if(regions, [](const TetRegion& region) { return region.tets.empty(); });
    return regions;
  }

  /// The number of a region that only the scene has.
  std::optional<int> added(const std::string& name) const {
    for (const int number : part_.added_regions)
      if (key_of_region(part_.regions, number) == name) return number;
    return std::nullopt;
  }

 private:
  // In file_mesh, where the tets of the bodies lie one after the other.
  std::uint32_t first_tet(std::size_t body) const {
    const std::vector<Tet>& tets = model_.file_mesh.tets;
    if (body == model_.bodies.size()) return static_cast<std::uint32_t>(tets.size());
    return static_cast<std::uint32_t>(
        std::partition_point(tets.begin(), tets.end(),
                             [&](const Tet& tet) { return tet[0] < model_.bodies[body].vertex_begin; }) -
        tets.begin());
  }

  const Model& model_;
  const BodyPart& part_;
  std::uint32_t first_;               // of its tets in file_mesh
  std::vector<std::size_t> painted_;  // [tets of its file] place in names_ plus 1; 0: the region of the file
  std::vector<std::string> names_;
};

bool has(const std::vector<TetRegion>& regions, const std::string& name) {
  return std::any_of(regions.begin(), regions.end(), [&](const TetRegion& region) { return region.name == name; });
}

}  // namespace

RegionSets painted_of(const Scene& scene) {
  RegionSets sets;
  for (const Body& body : scene.bodies) sets.push_back(body.regions);
  return sets;
}

Painting painting_of(const Scene& scene, const Model& model) {
  return {painted_of(scene), material_entries(scene, model, model.materials)};
}

Painting with_painted(const Scene& scene, const Model& model, std::span<const std::uint32_t> tets,
                      const std::string& name, const MaterialOverride& fresh) {
  Painting painting = painting_of(scene, model);
  for (std::size_t b = 0; b < painting.regions.size(); ++b) {
    const std::vector<TetRegion> before = painting.regions[b];
    PaintedBody body(model, b, before);
    body.paint(tets, name);
    const std::vector<TetRegion> after = body.regions();
    if (after == before) continue;
    painting.regions[b] = after;
    auto& entries = painting.materials[b].region_materials;
    for (const TetRegion& region : before)
      if (const auto number = body.added(region.name); number && !has(after, region.name))
        std::erase_if(entries, [&](const auto& entry) {
          return entry.first == region.name || entry.first == std::to_string(*number);
        });
    if (has(after, name) && !body.knows(name)) entries.emplace_back(name, fresh);
    std::sort(entries.begin(), entries.end(),
              [](const auto& left, const auto& right) { return left.first < right.first; });
  }
  return painting;
}

}  // namespace fascia
