#include "sim/mesh/io/formats.h"

#include <algorithm>

#include "base/error.h"

namespace fascia {
namespace {

std::string counted(std::size_t count, const char* one, const char* many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

void sort_unique(std::vector<std::uint32_t>& vertices, std::size_t vertex_count) {
  if (vertices.size() < vertex_count / 16) {
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    return;
  }
  std::vector<char> member(vertex_count, 0);  // marking is faster than sorting for a set of this size
  for (const std::uint32_t v : vertices) member[v] = 1;
  vertices.clear();
  for (std::size_t v = 0; v < vertex_count; ++v) {
    if (member[v]) vertices.push_back(static_cast<std::uint32_t>(v));
  }
  vertices.shrink_to_fit();
}

}  // namespace

void count_ignored(MeshFile& file, int dimension, int corners, std::size_t cells) {
  auto& ignored = file.ignored;
  (dimension == 0                   ? ignored.points
   : dimension == 1                 ? ignored.lines
   : dimension == 2 && corners == 3 ? ignored.triangles
   : dimension == 2                 ? ignored.polygons
                                    : ignored.others) += cells;
}

std::string region_group_name(const TetMesh& mesh, int region) {
  const auto named = mesh.region_names.find(region);
  return named != mesh.region_names.end() ? named->second : std::to_string(region);
}

std::map<std::string, std::vector<std::uint32_t>> region_groups(const TetMesh& mesh) {
  std::map<int, std::vector<std::uint32_t>> by_region;
  std::vector<std::uint32_t>* vertices = nullptr;
  for (std::size_t t = 0, last = 0; t < mesh.regions.size(); ++t) {
    if (mesh.regions[t] == 0) continue;
    if (!vertices || mesh.regions[t] != mesh.regions[last]) vertices = &by_region[mesh.regions[t]];
    last = t;
    vertices->insert(vertices->end(), mesh.tets[t].begin(), mesh.tets[t].end());
  }
  std::map<std::string, std::vector<std::uint32_t>> groups;
  for (auto& [region, list] : by_region) {
    sort_unique(list, mesh.positions.size());
    std::vector<std::uint32_t>& group = groups[region_group_name(mesh, region)];
    group.insert(group.end(), list.begin(), list.end());
  }
  for (auto& [name, list] : groups) sort_unique(list, mesh.positions.size());
  return groups;
}

std::vector<std::pair<std::string, const std::vector<std::uint32_t>*>> groups_beyond_regions(const TetMesh& mesh) {
  const auto of_regions = region_groups(mesh);
  std::vector<std::pair<std::string, const std::vector<std::uint32_t>*>> out;
  for (const auto& [name, vertices] : mesh.groups) {
    const auto region = of_regions.find(name);
    const bool is_region = region != of_regions.end() && region->second == vertices;
    if (!is_region && !vertices.empty()) out.emplace_back(name, &vertices);
  }
  return out;
}

void note_cut_off(const Scanner& in, MeshFile& file) {
  if (in.data().ends_with('\n')) return;
  const std::string name = std::filesystem::path(in.where()).filename().string();
  file.notes.push_back("The last line of " + name + " has no end; the file may be cut off.");
}

void check_vertex_count(const Scanner& in, std::size_t vertices) {
  constexpr std::size_t most = 0xfffffffe;
  if (vertices > most)
    in.fail("has " + std::to_string(vertices) + " vertices", "expected at most " + std::to_string(most));
}

void require_tets(const MeshFile& file, const std::string& where) {
  const auto& ignored = file.ignored;
  if (!file.mesh.tets.empty()) return;
  if (file.is_surface()) {
    throw Error(where, "is a surface of " + counted(file.faces.ends.size(), "face", "faces") + " without tets",
                "expected a tetrahedral mesh");
  }
  throw Error(where,
              "holds no tets (" + counted(file.mesh.positions.size(), "vertex", "vertices") + ", " +
                  counted(ignored.lines, "line", "lines") + ", " + counted(ignored.triangles, "triangle", "triangles") +
                  ", " + counted(ignored.polygons + ignored.others, "other cell", "other cells") + ")",
              "expected at least one");
}

void finish_mesh(MeshFile& file, const std::string& where) {
  TetMesh& mesh = file.mesh;
  const auto& ignored = file.ignored;
  if (!file.is_surface()) {
    require_tets(file, where);
    file.faces = {};
    file.vertex_colors.clear();
  }
  if (const auto& split = file.split; split.tets > 0) {
    std::string cells;
    const auto add = [&](std::size_t count, const char* one, const char* many) {
      if (count > 0) cells += (cells.empty() ? "" : ", ") + counted(count, one, many);
    };
    add(split.hexahedra, "hexahedron", "hexahedra");
    add(split.wedges, "wedge", "wedges");
    add(split.pyramids, "pyramid", "pyramids");
    file.notes.push_back(cells + " split into " + counted(split.tets, "tet", "tets") + ".");
  }
  if (ignored.others > 0)
    file.notes.push_back(counted(ignored.others, "cell", "cells") + " of other kinds than tets left out.");
  mesh.regions.resize(mesh.tets.size(), 0);
  for (auto& [name, vertices] : region_groups(mesh)) {
    std::vector<std::uint32_t>& group = mesh.groups[name];
    group.insert(group.end(), vertices.begin(), vertices.end());
  }
  for (auto& [name, vertices] : mesh.groups) sort_unique(vertices, mesh.positions.size());
}

}  // namespace fascia
