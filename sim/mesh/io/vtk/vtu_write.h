// Writes .vtu files: inline base64, uncompressed, which every reader of the format accepts.
#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim/mesh/tet_mesh.h"

namespace fascia {

struct VtuArray {
  std::string name;
  std::string_view type;                     // "Float64", "Int32", ...
  std::vector<std::string_view> components;  // their names; one empty name for a scalar
  std::string_view bytes;                    // of the values; not owned
};

template <class T>
std::string_view bytes_of(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

struct VtuGrid {
  const std::vector<Eigen::Vector3d>& points;
  const std::vector<Tet>& tets;
  const std::vector<MidEdges>& mid_edges;  // as of TetMesh
  std::vector<VtuArray> field_arrays, point_arrays, cell_arrays;
};
std::string vtu_text(const VtuGrid& grid);

/// The names of a mesh's regions, and its groups beyond them, as arrays that the .vtu reader recognizes.
class VtuNames {
 public:
  explicit VtuNames(const TetMesh& mesh);
  void add_to(VtuGrid& grid) const;  // which must not outlive this

 private:
  std::vector<std::pair<std::string, std::vector<std::int32_t>>> regions_;
  std::vector<std::pair<std::string, std::vector<std::uint8_t>>> groups_;  // [vertex] 1 for vertices of the group
};

/// Escapes text for an attribute's value.
std::string xml_escaped(std::string_view text);

}  // namespace fascia
