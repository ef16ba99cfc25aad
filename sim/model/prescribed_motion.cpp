#include "sim/model/prescribed_motion.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>

#include "base/error.h"
#include "sim/model/vertex_csv.h"

namespace fascia {

using Eigen::Vector3d;

Vector3d Motion::position(std::size_t k, const Vector3d& rest, double t) const {
  if (t < start) return rest;
  const double share = duration > 0 ? std::min((t - start) / duration, 1.0) : 1.0;
  if (!targets.empty()) return (1 - share) * rest + share * targets[k];  // exact at both ends
  if (share == 0) return rest;
  const Eigen::AngleAxisd rotation(share * angle, axis.normalized());
  return center + (1 + share * (scale - 1)) * (rotation * (rest - center)) + share * translate;
}

void place_prescribed(const Model& model, double t, std::vector<Vector3d>& displacement) {
  for (const Motion& motion : model.motions)
    for (std::size_t k = 0; k < motion.vertices.size(); ++k) {
      const std::uint32_t v = motion.vertices[k];
      displacement[v] = motion.position(k, model.rest_positions[v], t) - model.rest_positions[v];
    }
}

void leave_out(const std::set<std::uint32_t>& others, Motion& motion) {
  std::vector<std::uint32_t>& vertices = motion.vertices;
  std::vector<Vector3d>& targets = motion.targets;
  std::size_t kept = 0;
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    if (others.contains(vertices[k])) continue;
    vertices[kept] = vertices[k];
    if (!targets.empty()) targets[kept] = targets[k];
    ++kept;
  }
  vertices.resize(kept);
  if (!targets.empty()) targets.resize(kept);
}

Motion resolve_motion(const PrescribedMotion& motion, FileReader& files, const SelectableMesh& body,
                      const std::string& where, const std::string& key) {
  Motion result;
  result.start = motion.start;
  result.duration = motion.duration;
  if (motion.select) result.vertices = select_vertices(*motion.select, body, where + ".select");
  if (motion.targets.empty()) {
    result.translate = motion.translate;
    result.axis = motion.axis;
    result.center = motion.center;
    result.angle = motion.angle_deg * std::numbers::pi / 180;
    result.scale = motion.scale;
    return result;
  }
  const FileReader::File file = files.read(motion.targets, key + ".targets");
  VertexTable table = files.blaming(
      file, [&] { return read_vertex_csv_content(file.place, file.content, body.mesh.positions.size()); });
  if (!motion.select) {
    result.vertices = std::move(table.vertices);
    result.targets = std::move(table.values);
    return result;
  }
  for (const std::uint32_t vertex : result.vertices) {
    const auto row = std::lower_bound(table.vertices.begin(), table.vertices.end(), vertex);
    if (row == table.vertices.end() || *row != vertex) {
      throw Error(where + ".targets: " + file.place.string(),
                  "misses vertex " + std::to_string(vertex) + ", which " + where + ".select selects",
                  "expected a line for each of the " + std::to_string(result.vertices.size()) + " selected vertices");
    }
    result.targets.push_back(table.values[static_cast<std::size_t>(row - table.vertices.begin())]);
  }
  return result;
}

}  // namespace fascia
