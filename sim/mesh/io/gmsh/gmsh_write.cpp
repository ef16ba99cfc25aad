// Writing Gmsh .msh, 4.1 and 2.2 in ASCII. A region becomes a physical volume; any other vertex group becomes a
// physical point group with one point element per vertex, the format's representation of a set of vertices.
#include <algorithm>
#include <set>

#include "base/error.h"
#include "base/number_text.h"
#include "sim/mesh/io/formats.h"

namespace fascia {
namespace {

struct PointGroup {
  int tag;
  const std::vector<std::uint32_t>* vertices;
};

struct Groups {
  std::vector<int> regions;  // ascending, 0 included if any tet has none
  std::vector<PointGroup> points;
  std::string physical_names;  // the section, or empty
};

/// The physical tag that a group without a name must keep, or 0.
int tag_in(const std::string& name) {
  int tag = 0;
  const auto [stop, status] = std::from_chars(name.data(), name.data() + name.size(), tag);
  return status == std::errc{} && stop == name.data() + name.size() && std::to_string(tag) == name && tag > 0 ? tag : 0;
}

void add_name(NumberText& out, const std::string& where, int dimension, int tag, const std::string& name) {
  if (name.find_first_of("\"\n\r") != std::string::npos) {
    throw Error(where, "name '" + name.substr(0, name.find_first_of("\n\r")) + "' has a quote or a line break",
                "expected none in a .msh file");
  }
  out.add(dimension).add(' ').add(tag).add(" \"").add(name).add("\"\n");
}

Groups groups_of(const std::string& where, const TetMesh& mesh) {
  Groups out;
  std::set<int> regions;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    if (t == 0 || region_of(mesh, t) != region_of(mesh, t - 1)) regions.insert(region_of(mesh, t));
  }
  out.regions.assign(regions.begin(), regions.end());
  if (!out.regions.empty() && out.regions[0] < 0) {
    throw Error(where, "region " + std::to_string(out.regions[0]) + " cannot be a physical group",
                "expected 0 or more in a .msh file; .vtu, .vtk and .mesh hold any number");
  }

  const auto groups = groups_beyond_regions(mesh);
  NumberText names;
  std::size_t name_count = 0;
  int next_tag = 1;
  for (const auto& [name, vertices] : groups) next_tag = std::max(next_tag, std::min(tag_in(name), 2000000000) + 1);
  for (const auto& [name, vertices] : groups) {
    int tag = tag_in(name);
    if (tag == 0) {
      tag = next_tag++;
      add_name(names, where, 0, tag, name);
      ++name_count;
    }
    out.points.push_back({tag, vertices});
  }
  for (const auto& [region, name] : mesh.region_names) {
    if (region <= 0) continue;
    add_name(names, where, 3, region, name);
    ++name_count;
  }
  if (name_count > 0) {
    out.physical_names = "$PhysicalNames\n" + std::to_string(name_count) + "\n" + names.take() + "$EndPhysicalNames\n";
  }
  return out;
}

void add_point(NumberText& out, const Eigen::Vector3d& x) { out.add(x[0]).add(' ').add(x[1]).add(' ').add(x[2]); }

/// Tets have type 4, and those with mid-edge vertices type 11.
int type_of(const TetMesh& mesh, std::size_t t) {
  return mesh.mid_edges.empty() || mesh.mid_edges[t] == kNoMidEdges ? 4 : 11;
}

/// Nodes are numbered from 1; Gmsh has the middle of edge 23 before that of 13.
void add_nodes(NumberText& out, const TetMesh& mesh, std::size_t t) {
  for (const std::uint32_t v : mesh.tets[t]) out.add(' ').add(v + std::size_t{1});
  if (type_of(mesh, t) == 11)
    for (const std::size_t m : {0, 1, 2, 3, 5, 4}) out.add(' ').add(mesh.mid_edges[t][m] + std::size_t{1});
  out.add('\n');
}

std::size_t element_count(const TetMesh& mesh, const Groups& groups) {
  std::size_t count = mesh.tets.size();
  for (const PointGroup& group : groups.points) count += group.vertices->size();
  return count;
}

/// Region 0 needs an entity too; entities are numbered from 1.
int entity_of(const Groups& groups, int region) {
  return static_cast<int>(std::lower_bound(groups.regions.begin(), groups.regions.end(), region) -
                          groups.regions.begin()) +
         1;
}

void add_entities(NumberText& out, const TetMesh& mesh, const Groups& groups) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& x : mesh.positions) box.extend(x);
  out.add("$Entities\n").add(groups.points.size()).add(" 0 0 ").add(groups.regions.size()).add('\n');
  for (std::size_t g = 0; g < groups.points.size(); ++g) {
    out.add(g + 1).add(' ');
    add_point(out, mesh.positions[groups.points[g].vertices->front()]);
    out.add(" 1 ").add(groups.points[g].tag).add('\n');
  }
  for (const int region : groups.regions) {
    out.add(entity_of(groups, region)).add(' ');
    add_point(out, box.min());
    out.add(' ');
    add_point(out, box.max());
    out.add(region == 0 ? " 0" : " 1 ");
    if (region != 0) out.add(region);
    out.add(" 0\n");
  }
  out.add("$EndEntities\n");
}

}  // namespace

std::string gmsh41_text(const std::string& where, const TetMesh& mesh) {
  const Groups groups = groups_of(where, mesh);
  NumberText out;
  out.add("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n").add(groups.physical_names);
  add_entities(out, mesh, groups);

  const std::size_t n = mesh.positions.size();
  out.add("$Nodes\n1 ").add(n).add(" 1 ").add(n).add("\n3 1 0 ").add(n).add('\n');
  for (std::size_t v = 1; v <= n; ++v) out.add(v).add('\n');
  for (const Eigen::Vector3d& x : mesh.positions) {
    add_point(out, x);
    out.add('\n');
  }
  out.add("$EndNodes\n");

  // A block holds tets of one region and type; several blocks of the same region keep the order of the tets.
  std::vector<std::size_t> begins;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    if (t == 0 || region_of(mesh, t) != region_of(mesh, t - 1) || type_of(mesh, t) != type_of(mesh, t - 1))
      begins.push_back(t);
  }
  const std::size_t elements = element_count(mesh, groups);
  out.add("$Elements\n")
      .add(begins.size() + groups.points.size())
      .add(' ')
      .add(elements)
      .add(" 1 ")
      .add(elements)
      .add('\n');
  std::size_t element = 0;
  for (std::size_t b = 0; b < begins.size(); ++b) {
    const std::size_t end = b + 1 < begins.size() ? begins[b + 1] : mesh.tets.size();
    out.add("3 ").add(entity_of(groups, region_of(mesh, begins[b]))).add(' ').add(type_of(mesh, begins[b]));
    out.add(' ').add(end - begins[b]).add('\n');
    for (std::size_t t = begins[b]; t < end; ++t) {
      out.add(++element);
      add_nodes(out, mesh, t);
    }
  }
  for (std::size_t g = 0; g < groups.points.size(); ++g) {
    const auto& vertices = *groups.points[g].vertices;
    out.add("0 ").add(g + 1).add(" 15 ").add(vertices.size()).add('\n');
    for (const std::uint32_t v : vertices) out.add(++element).add(' ').add(v + std::size_t{1}).add('\n');
  }
  return out.add("$EndElements\n").take();
}

std::string gmsh22_text(const std::string& where, const TetMesh& mesh) {
  const Groups groups = groups_of(where, mesh);
  NumberText out;
  out.add("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n").add(groups.physical_names);
  out.add("$Nodes\n").add(mesh.positions.size()).add('\n');
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    out.add(v + 1).add(' ');
    add_point(out, mesh.positions[v]);
    out.add('\n');
  }
  out.add("$EndNodes\n$Elements\n").add(element_count(mesh, groups)).add('\n');
  std::size_t element = 0;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    const int region = region_of(mesh, t);
    out.add(++element).add(' ').add(type_of(mesh, t)).add(" 2 ").add(region).add(' ').add(entity_of(groups, region));
    add_nodes(out, mesh, t);
  }
  for (std::size_t g = 0; g < groups.points.size(); ++g) {
    for (const std::uint32_t v : *groups.points[g].vertices) {
      out.add(++element)
          .add(" 15 2 ")
          .add(groups.points[g].tag)
          .add(' ')
          .add(g + 1)
          .add(' ')
          .add(v + std::size_t{1})
          .add('\n');
    }
  }
  return out.add("$EndElements\n").take();
}

}  // namespace fascia
