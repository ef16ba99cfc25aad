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
/// "lowest": the vertices within `share` of the height from the bottom along Body::up or, if those are fewer, the
/// lowest `share` of all vertices. "highest": the same from the top.
struct LowestSelection {
  double share;
  bool highest = false;
  bool each_piece = false;  // of every connected piece of the mesh by itself
  bool operator==(const LowestSelection&) const = default;
};
using Selection = std::variant<BoxSelection, SphereSelection, VertexSelection, GroupSelection, LowestSelection>;

}  // namespace fascia
