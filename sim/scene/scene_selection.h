// The selections of a scene file, which name vertices of a body (sim/model/vertex_selection.h resolves them).
#pragma once
#include <Eigen/Core>
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
/// "lowest": the vertices within `share` of the height from the bottom along y or, if those are fewer, the lowest
/// `share` of all vertices. These are fixed when a mesh is opened on its own.
struct LowestSelection {
  double share;
  bool operator==(const LowestSelection&) const = default;
};
using Selection = std::variant<BoxSelection, SphereSelection, VertexSelection, GroupSelection, LowestSelection>;

}  // namespace fascia
