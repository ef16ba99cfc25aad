// The selections of a scene file, which name vertices of a body (sim/model/vertex_selection.h resolves them), and the
// tets of its regions.
#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace fascia {

struct BoxSelection {
  Eigen::Vector3d min, max;  // closed, on rest positions before the transform
  bool operator==(const BoxSelection&) const = default;
};
struct SphereSelection {
  Eigen::Vector3d center;
  double radius;
  bool operator==(const SphereSelection&) const = default;
};
struct VertexSelection {
  std::vector<std::uint32_t> vertices;
  bool operator==(const VertexSelection&) const = default;
};
struct GroupSelection {
  std::string group;
  bool operator==(const GroupSelection&) const = default;
};
/// "lowest": the vertices within `share` of the height from the bottom along Body::up or, if those are fewer, the
/// lowest `share` of all vertices. "highest": the same from the top.
struct LowestSelection {
  double share;
  bool highest = false;
  bool each_piece = false;  // of every connected piece of the mesh by itself
  bool operator==(const LowestSelection&) const = default;
};
/// Tets of a mesh as its file has them, `first` and `last` included.
struct TetRange {
  std::uint32_t first, last;
  bool operator==(const TetRange&) const = default;
};
/// The same tets, ascending and with gaps between the ranges.
inline std::vector<TetRange> joined(std::vector<TetRange> ranges) {
  std::sort(ranges.begin(), ranges.end(), [](const TetRange& a, const TetRange& b) { return a.first < b.first; });
  std::vector<TetRange> apart;
  for (const TetRange& range : ranges) {
    if (apart.empty() || range.first > apart.back().last + 1)
      apart.push_back(range);
    else
      apart.back().last = std::max(apart.back().last, range.last);
  }
  return apart;
}
/// Tets that belong to this region whatever the mesh file says: an entry of "regions".
struct TetRegion {
  std::string name;            // name or number of a region of the mesh, or a new name
  std::vector<TetRange> tets;  // joined
  bool operator==(const TetRegion&) const = default;
};

using Selection = std::variant<BoxSelection, SphereSelection, VertexSelection, GroupSelection, LowestSelection>;

}  // namespace fascia
