#include "sim/mesh/tet_faces.h"

#include <algorithm>
#include <cstddef>

namespace fascia {
namespace {

// Corner lists of the faces opposite to corner 0, 1, 2, 3, wound outward for a tet of positive volume.
constexpr int kFaces[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};

struct Face {
  std::uint32_t low, middle, high;  // the vertices in ascending order, equal for both sides of a shared face
  std::size_t id;                   // 4 * tet + face
  bool same_vertices(const Face& other) const {
    return low == other.low && middle == other.middle && high == other.high;
  }
};

Face make_face(const std::vector<Tet>& tets, std::size_t id) {
  const Tet& tet = tets[id / 4];
  const int* corners = kFaces[id % 4];
  std::uint32_t a = tet[corners[0]], b = tet[corners[1]], c = tet[corners[2]];
  if (a > b) std::swap(a, b);
  if (b > c) std::swap(b, c);
  if (a > b) std::swap(a, b);
  return {a, b, c, id};
}

/// All faces, grouped by their lowest vertex: a counting sort, so that only short runs remain to be compared.
std::vector<Face> faces_by_lowest_vertex(const std::vector<Tet>& tets, std::vector<std::size_t>& group_begin) {
  std::uint32_t last = 0;
  for (const Tet& tet : tets) last = std::max(last, *std::max_element(tet.begin(), tet.end()));
  group_begin.assign(std::size_t{last} + 2, 0);
  const std::size_t count = 4 * tets.size();
  for (std::size_t id = 0; id < count; ++id) ++group_begin[make_face(tets, id).low + 1];
  for (std::size_t v = 0; v <= last; ++v) group_begin[v + 1] += group_begin[v];
  std::vector<Face> faces(count);
  std::vector<std::size_t> next(group_begin.begin(), group_begin.end() - 1);
  for (std::size_t id = 0; id < count; ++id) {
    const Face face = make_face(tets, id);
    faces[next[face.low]++] = face;
  }
  return faces;
}

/// Calls `visit` with every run of faces that have the same vertices.
template <typename Visit>
void for_each_face(const std::vector<Tet>& tets, const Visit& visit) {
  std::vector<std::size_t> group_begin;
  std::vector<Face> faces = faces_by_lowest_vertex(tets, group_begin);
  for (std::size_t group = 0; group + 1 < group_begin.size(); ++group) {
    const auto begin = faces.begin() + static_cast<std::ptrdiff_t>(group_begin[group]);
    const auto end = faces.begin() + static_cast<std::ptrdiff_t>(group_begin[group + 1]);
    std::sort(begin, end, [](const Face& a, const Face& b) {
      return a.middle != b.middle ? a.middle < b.middle : a.high < b.high;
    });
    for (auto face = begin; face != end;) {
      auto other = face + 1;
      while (other != end && other->same_vertices(*face)) ++other;
      visit(face, other);
      face = other;
    }
  }
}

/// [4 * tet_count] 1 for faces of exactly one tet.
std::vector<char> faces_at_boundary(const std::vector<Tet>& tets) {
  std::vector<char> on_boundary(4 * tets.size(), 0);
  for_each_face(tets, [&](auto begin, auto end) {
    if (end - begin == 1) on_boundary[begin->id] = 1;
  });
  return on_boundary;
}

}  // namespace

std::vector<Triangle> boundary_triangles(const std::vector<Tet>& tets) {
  const std::vector<char> on_boundary = faces_at_boundary(tets);
  std::vector<Triangle> triangles;
  for (std::size_t id = 0; id < on_boundary.size(); ++id) {
    if (!on_boundary[id]) continue;
    const int* corners = kFaces[id % 4];
    triangles.push_back({tets[id / 4][corners[0]], tets[id / 4][corners[1]], tets[id / 4][corners[2]]});
  }
  return triangles;
}

std::vector<std::uint32_t> tets_at_boundary(const std::vector<Tet>& tets) {
  const std::vector<char> on_boundary = faces_at_boundary(tets);
  std::vector<std::uint32_t> result;
  for (std::size_t id = 0; id < on_boundary.size(); ++id)
    if (on_boundary[id]) result.push_back(static_cast<std::uint32_t>(id / 4));
  return result;
}

std::vector<std::uint32_t> tets_across_faces(const std::vector<Tet>& tets) {
  std::vector<std::uint32_t> across(4 * tets.size(), kNoTet);
  for_each_face(tets, [&](auto begin, auto end) {
    if (end - begin != 2) return;
    across[begin->id] = static_cast<std::uint32_t>((begin + 1)->id / 4);
    across[(begin + 1)->id] = static_cast<std::uint32_t>(begin->id / 4);
  });
  return across;
}

}  // namespace fascia
