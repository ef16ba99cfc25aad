#include "sim/mesh/io/fem/merged_mesh.h"

#include <algorithm>
#include <numeric>

#include "sim/mesh/io/formats.h"

namespace fascia {
namespace {

void merge_regions(TetMesh& mesh, const TetMesh& part, const std::string& name) {
  int region = mesh.region_names.empty() ? 0 : mesh.region_names.rbegin()->first;
  std::map<int, int> merged;  // from regions of the part
  for (const int own : part.regions) {
    const auto [entry, is_new] = merged.try_emplace(own, region + 1);
    if (is_new) mesh.region_names[++region] = own == 0 ? name : name + "." + region_group_name(part, own);
    mesh.regions.push_back(entry->second);
  }
}

void merge_groups(TetMesh& mesh, const TetMesh& part, std::uint32_t first, const std::string& name,
                  const std::string& shared) {
  const auto add = [&](const std::string& group, const std::vector<std::uint32_t>& vertices) {
    for (const std::uint32_t v : vertices) mesh.groups[group].push_back(first + v);
  };
  for (const auto& [group, vertices] : part.groups)
    add(group.ends_with(shared) ? group.substr(0, group.size() - shared.size()) : name + "." + group, vertices);
  std::vector<std::uint32_t> all(part.positions.size());
  std::iota(all.begin(), all.end(), 0u);
  add(name, all);
}

void merge_counts(MeshFile& file, const MeshFile& part) {
  file.ignored.points += part.ignored.points;
  file.ignored.lines += part.ignored.lines;
  file.ignored.triangles += part.ignored.triangles;
  file.ignored.polygons += part.ignored.polygons;
  file.ignored.others += part.ignored.others;
  file.split.hexahedra += part.split.hexahedra;
  file.split.wedges += part.split.wedges;
  file.split.pyramids += part.split.pyramids;
  file.split.tets += part.split.tets;
}

}  // namespace

void merge_mesh(MeshFile& file, const MeshFile& part, const std::string& name, const std::string& shared) {
  TetMesh& mesh = file.mesh;
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const std::size_t first_tet = mesh.tets.size();
  mesh.positions.insert(mesh.positions.end(), part.mesh.positions.begin(), part.mesh.positions.end());
  for (Tet tet : part.mesh.tets) {
    for (std::uint32_t& v : tet) v += first;
    mesh.tets.push_back(tet);
  }
  if (!part.mid_edges.empty()) file.mid_edges.resize(first_tet, kNoMidEdges);
  for (MidEdges mid_edges : part.mid_edges) {
    for (std::uint32_t& v : mid_edges) v = v == kNoVertex ? v : v + first;
    file.mid_edges.push_back(mid_edges);
  }
  const std::size_t first_corner = file.faces.corners.size();
  for (const std::uint32_t v : part.faces.corners) file.faces.corners.push_back(first + v);
  for (const std::size_t end : part.faces.ends) file.faces.ends.push_back(first_corner + end);
  merge_regions(mesh, part.mesh, name);
  merge_groups(mesh, part.mesh, first, name, shared);
  merge_counts(file, part);
  for (const std::string& note : part.notes)
    if (std::find(file.notes.begin(), file.notes.end(), note) == file.notes.end()) file.notes.push_back(note);
}

}  // namespace fascia
