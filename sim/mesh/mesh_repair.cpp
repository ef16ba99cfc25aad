// Selects the tets of a file that the simulation can use.
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "sim/mesh/mesh_check.h"

namespace fascia {
namespace {

constexpr double kSmallestHeight = 1e-7;  // of the longest edge; see MeshRepair::degenerate

bool is_degenerate(const std::array<Eigen::Vector3d, 4>& p, double volume6) {
  double longest = 0;       // squared edge
  double largest_face = 0;  // squared, of twice the area
  for (std::size_t a = 0; a < 4; ++a) {
    for (std::size_t b = a + 1; b < 4; ++b) longest = std::max(longest, (p[b] - p[a]).squaredNorm());
    const Eigen::Vector3d &u = p[(a + 1) % 4], &v = p[(a + 2) % 4], &w = p[(a + 3) % 4];
    largest_face = std::max(largest_face, (v - u).cross(w - u).squaredNorm());
  }
  const double height = std::abs(volume6) / std::sqrt(largest_face);
  return !(height > kSmallestHeight * std::sqrt(longest));  // in this form 0/0 counts as degenerate, too
}

/// [usable tet] 1 if an earlier usable tet has the same four vertices.
std::vector<char> find_duplicates(const std::vector<Tet>& tets) {
  struct Entry {
    Tet vertices;  // ascending
    std::size_t index;
    bool operator<(const Entry& other) const {
      return vertices != other.vertices ? vertices < other.vertices : index < other.index;
    }
  };
  std::vector<Entry> entries(tets.size());
  for (std::size_t t = 0; t < tets.size(); ++t) {
    entries[t] = {tets[t], t};
    std::sort(entries[t].vertices.begin(), entries[t].vertices.end());
  }
  std::sort(entries.begin(), entries.end());
  std::vector<char> duplicate(tets.size(), 0);
  for (std::size_t e = 1; e < entries.size(); ++e) {
    if (entries[e].vertices == entries[e - 1].vertices) duplicate[entries[e].index] = 1;
  }
  return duplicate;
}

}  // namespace

MeshRepair repair(const TetMesh& mesh) {
  std::vector<Tet> tets;
  std::vector<std::uint32_t> source;
  std::vector<char> reoriented;
  MeshRepair result;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    Tet tet = mesh.tets[t];
    std::array<Eigen::Vector3d, 4> p;
    for (std::size_t corner = 0; corner < 4; ++corner) p[corner] = mesh.positions[tet[corner]];
    const double volume6 = signed_volume6(p[0], p[1], p[2], p[3]);
    if (is_degenerate(p, volume6)) {
      result.degenerate.push_back(static_cast<std::uint32_t>(t));
      continue;
    }
    if (volume6 < 0) std::swap(tet[2], tet[3]);
    tets.push_back(tet);
    source.push_back(static_cast<std::uint32_t>(t));
    reoriented.push_back(volume6 < 0);
  }
  const std::vector<char> duplicate = find_duplicates(tets);
  for (std::size_t t = 0; t < tets.size(); ++t) {
    if (duplicate[t]) {
      result.duplicated.push_back(source[t]);
      continue;
    }
    if (reoriented[t]) result.flipped.push_back(source[t]);
    result.tets.push_back(tets[t]);
    result.source.push_back(source[t]);
  }
  return result;
}

}  // namespace fascia
