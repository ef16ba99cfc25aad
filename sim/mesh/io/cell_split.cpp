#include "sim/mesh/io/cell_split.h"

#include <algorithm>
#include <array>

#include "sim/mesh/io/formats.h"

namespace fascia {
namespace {

using Quad = std::array<int, 4>;  // corners of a face, outward; -1 at the end of a triangle

constexpr std::array<Quad, 5> kPyramid = {{{0, 3, 2, 1}, {0, 1, 4, -1}, {1, 2, 4, -1}, {2, 3, 4, -1}, {3, 0, 4, -1}}};
constexpr std::array<Quad, 5> kWedge = {{{0, 2, 1, -1}, {3, 4, 5, -1}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}}};
constexpr std::array<Quad, 6> kHexahedron = {
    {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};

std::span<const Quad> faces_of(std::size_t corners) {
  if (corners == 5) return kPyramid;
  if (corners == 6) return kWedge;
  return kHexahedron;
}

bool has_twice(const Tet& tet) {
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (tet[i] == tet[k]) return true;
  return false;
}

/// Tets from `apex` to the triangles of a face.
void add_cone(std::uint32_t apex, std::span<const std::uint32_t> face, std::vector<Tet>& tets) {
  const auto lowest = static_cast<std::size_t>(std::min_element(face.begin(), face.end()) - face.begin());
  const std::size_t n = face.size();
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const Tet tet{apex, face[lowest], face[(lowest + i) % n], face[(lowest + i + 1) % n]};
    if (!has_twice(tet)) tets.push_back(tet);
  }
}

double volume6(const std::vector<Eigen::Vector3d>& x, const Tet& t) {
  return signed_volume6(x[t[0]], x[t[1]], x[t[2]], x[t[3]]);
}

}  // namespace

std::size_t add_solid(MeshFile& file, std::span<const std::uint32_t> corners) {
  std::vector<Tet>& tets = file.mesh.tets;
  if (corners.size() == 4) {
    tets.push_back({corners[0], corners[1], corners[2], corners[3]});
    return 1;
  }
  const std::size_t first = tets.size();
  // All faces at the lowest vertex have their diagonals there; tets from it to the other faces fill the cell.
  const std::uint32_t apex = *std::min_element(corners.begin(), corners.end());
  for (const Quad& face : faces_of(corners.size())) {
    std::array<std::uint32_t, 4> vertices{};
    std::size_t n = 0;
    while (n < 4 && face[n] >= 0) {
      vertices[n] = corners[static_cast<std::size_t>(face[n])];
      ++n;
    }
    const std::span<const std::uint32_t> own(vertices.data(), n);
    if (std::find(own.begin(), own.end(), apex) == own.end()) add_cone(apex, own, tets);
  }
  // Programs disagree about the winding of wedges. A tet that is inside out in a cell that is not stays so: the cell is
  // twisted.
  double volume = 0;
  for (std::size_t t = first; t < tets.size(); ++t) volume += volume6(file.mesh.positions, tets[t]);
  for (std::size_t t = first; t < tets.size() && volume < 0; ++t) std::swap(tets[t][2], tets[t][3]);
  const std::size_t added = tets.size() - first;
  if (added == 0) {
    count_ignored(file, 3, static_cast<int>(corners.size()));
    return 0;
  }
  auto& split = file.split;
  ++(corners.size() == 5 ? split.pyramids : corners.size() == 6 ? split.wedges : split.hexahedra);
  split.tets += added;
  return added;
}

void set_mid_edges(MeshFile& file, const MidEdges& mid_edges) {
  file.mid_edges.resize(file.mesh.tets.size(), kNoMidEdges);
  file.mid_edges.back() = mid_edges;
}

void add_face(MeshFile& file, std::span<const std::uint32_t> corners) {
  const auto count = static_cast<int>(std::min<std::size_t>(corners.size(), 4));
  count_ignored(file, std::max(0, std::min(count, 3) - 1), count);
  if (count < 3) return;
  file.faces.corners.insert(file.faces.corners.end(), corners.begin(), corners.end());
  file.faces.ends.push_back(file.faces.corners.size());
}

}  // namespace fascia
