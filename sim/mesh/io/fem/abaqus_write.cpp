#include "sim/mesh/io/fem/abaqus_write.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <set>
#include <span>
#include <vector>

#include "base/number_text.h"
#include "sim/mesh/io/formats.h"

namespace fascia {
namespace {

constexpr std::size_t kLongestName = 60;    // of the 80 characters that programs take
constexpr std::size_t kLongestNumber = 20;  // CalculiX cuts off the rest

/// Sets differ beyond upper and lower case.
class SetNames {
 public:
  std::string of(const std::string& wanted) {
    std::string name = wanted.substr(0, kLongestName);
    for (char& c : name)
      if (!std::isalnum(static_cast<unsigned char>(c)) && c != '_' && c != '-') c = '_';
    if (name.empty() || !std::isalpha(static_cast<unsigned char>(name[0]))) name = "set_" + name;
    std::string free = name;
    for (int k = 2; !taken_.insert(upper_case(free)).second; ++k) free = name + "_" + std::to_string(k);
    return free;
  }

 private:
  static std::string upper_case(std::string text) {
    for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return text;
  }
  std::set<std::string> taken_;
};

void add_coordinate(NumberText& out, double value) {
  char digits[32];
  char* end = std::to_chars(digits, digits + sizeof digits, value).ptr;
  if (end - digits > static_cast<std::ptrdiff_t>(kLongestNumber))
    end = std::to_chars(digits, digits + sizeof digits, value, std::chars_format::general, 13).ptr;
  out.add(", ").add(std::string_view(digits, static_cast<std::size_t>(end - digits)));
}

bool is_quadratic(const TetMesh& mesh, std::size_t t) {
  return !mesh.mid_edges.empty() && mesh.mid_edges[t] != kNoMidEdges;
}

void add_element(NumberText& out, const TetMesh& mesh, std::size_t t) {
  out.add(t + 1);
  for (const std::uint32_t v : mesh.tets[t]) out.add(", ").add(v + std::size_t{1});
  if (is_quadratic(mesh, t))
    for (const std::uint32_t v : mesh.mid_edges[t]) out.add(", ").add(v + std::size_t{1});
  out.add('\n');
}

// Lines end before the 132 characters that CalculiX reads.
void add_members(NumberText& out, std::span<const std::uint32_t> vertices) {
  constexpr std::size_t kOnLine = 10;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (i > 0) out.add(i % kOnLine == 0 ? ",\n" : ", ");
    out.add(vertices[i] + std::size_t{1});
  }
  out.add('\n');
}

std::map<int, std::string> region_sets(const TetMesh& mesh) {
  std::set<int> regions;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    if (t == 0 || region_of(mesh, t) != region_of(mesh, t - 1)) regions.insert(region_of(mesh, t));
  std::map<int, std::string> sets;
  SetNames names;
  for (const int region : regions) {
    const auto known = mesh.region_names.find(region);
    if (known != mesh.region_names.end())
      sets[region] = names.of(known->second);
    else if (region != 0)
      sets[region] = names.of("region_" + std::to_string(region));
  }
  return sets;
}

}  // namespace

AbaqusMesh abaqus_mesh(const TetMesh& mesh) {
  AbaqusMesh result;
  result.regions = region_sets(mesh);
  NumberText out;
  out.add("*NODE\n");
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    out.add(v + 1);
    for (const double x : mesh.positions[v]) add_coordinate(out, x);
    out.add('\n');
  }
  // A block holds tets of one region and type; several blocks of the same set keep the order of the tets.
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    if (t == 0 || region_of(mesh, t) != region_of(mesh, t - 1) || is_quadratic(mesh, t) != is_quadratic(mesh, t - 1)) {
      out.add("*ELEMENT, TYPE=").add(is_quadratic(mesh, t) ? "C3D10" : "C3D4");
      if (const auto set = result.regions.find(region_of(mesh, t)); set != result.regions.end())
        out.add(", ELSET=").add(set->second);
      out.add('\n');
    }
    add_element(out, mesh, t);
  }
  SetNames names;
  for (const auto& [name, vertices] : groups_beyond_regions(mesh)) {
    if (vertices->empty()) continue;
    out.add("*NSET, NSET=").add(result.groups[name] = names.of(name)).add('\n');
    add_members(out, *vertices);
  }
  result.text = out.take();
  return result;
}

std::string abaqus_text(const TetMesh& mesh) { return abaqus_mesh(mesh).text; }

}  // namespace fascia
