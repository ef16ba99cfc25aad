// Vectors at vertices from CSV files `index,x,y,z`: prescribed targets and initial velocities.
#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

namespace fascia {

struct VertexTable {
  std::vector<std::uint32_t> vertices;  // [row] ascending, unique
  std::vector<Eigen::Vector3d> values;  // [row]
};

/// Reads a file whose rows may be in any order and whose first line may be a header. Throws Error "file:line: ..." for
/// a row that is not four finite numbers, an index that is repeated or not below `vertex_count`; also for no rows.
VertexTable read_vertex_csv(const std::filesystem::path& path, std::size_t vertex_count);
/// As read_vertex_csv of a file with this content.
VertexTable read_vertex_csv_content(const std::filesystem::path& path, std::string_view content,
                                    std::size_t vertex_count);

/// The same, and every vertex must have a row: [vertex_count].
std::vector<Eigen::Vector3d> read_complete_vertex_csv(const std::filesystem::path& path, std::size_t vertex_count);
std::vector<Eigen::Vector3d> read_complete_vertex_csv(const std::filesystem::path& path, std::string_view content,
                                                      std::size_t vertex_count);

}  // namespace fascia
