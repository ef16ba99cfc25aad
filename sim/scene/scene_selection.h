// Which vertices of a body a scene file means (model_selection.h finds them).
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
/// "lowest": the vertices within `share` of the height from the bottom along y, or, where those are fewer, this share
/// of all vertices, those that lie lowest; how a mesh alone is held.
struct LowestSelection {
  double share;
  bool operator==(const LowestSelection&) const = default;
};
using Selection = std::variant<BoxSelection, SphereSelection, VertexSelection, GroupSelection, LowestSelection>;

}  // namespace fascia
