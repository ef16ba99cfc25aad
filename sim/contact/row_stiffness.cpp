#include "sim/contact/row_stiffness.h"

#include <algorithm>
#include <cmath>

#include "sim/tool/shape_distance.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

/// [point] how many share the stiffness of one, by the forces [point]: those before, or less the expected ones.
std::vector<double> sharing(const ContactSurface& surface, const std::vector<double>& forces, std::size_t vertices) {
  struct Sums {
    double force = 0, square = 0;
  };
  std::vector<Sums> before(vertices), expected(vertices);
  for (std::size_t p = 0; p < forces.size(); ++p)
    for (std::size_t k = 0; k < 3; ++k) {
      const ContactPoint& point = surface.points[p];
      Sums& sums = (forces[p] > 0 ? before : expected)[point.vertices[k]];
      sums.force += point.weights[k] * std::abs(forces[p]);
      sums.square += point.weights[k] * forces[p] * forces[p];
    }
  std::vector<double> counts(forces.size(), 1);
  for (std::size_t p = 0; p < forces.size(); ++p) {
    const ContactPoint& point = surface.points[p];
    double mean = 0;
    for (std::size_t k = 0; k < 3; ++k)
      if (const Sums& sums = (before[point.vertices[k]].square > 0 ? before : expected)[point.vertices[k]];
          sums.square > 0)
        mean += point.weights[k] * sums.force * sums.force / sums.square;
    counts[p] = std::max(1.0, mean);
  }
  return counts;
}

}  // namespace

std::vector<double> row_stiffness(const Model& model, const ContactSurface& surface,
                                  const std::vector<double>& stiffness, const ContactMemory& memory,
                                  const ToolMotion& motion, const std::vector<Vector3d>& start,
                                  const std::vector<Vector3d>& ahead) {
  std::vector<double> rows;
  rows.reserve(surface.row_count);
  for (const ContactPiece& piece : surface.pieces) {
    rows.insert(rows.end(), stiffness.begin(), stiffness.begin() + piece.points);
    if (piece.level == 0) continue;
    const Tool& tool = model.tools[piece.tool];
    const RigidPose from = tool.pose_of_piece(piece.piece, motion.from[piece.tool]),
                    to = tool.pose_of_piece(piece.piece, motion.to[piece.tool]);
    std::vector<double> forces(piece.points, 0);
    for (std::uint32_t p = 0; p < piece.points; ++p) {
      const ContactPoint& point = surface.points[p];
      const double before = memory.size() < surface.row_count ? 0 : memory[piece.first_row + p].normal;
      if (!has_row(surface, piece, p, tool.shape, point.place(model.rest_positions, start), from, to, before)) {
        rows[piece.first_row + p] = 0;
        continue;
      }
      const double gap = distance_to(tool.shape, to.to_local(point.place(model.rest_positions, ahead))).distance;
      const double reach = 0.5 * model.contact.thickness + surface.first_reach;
      forces[p] = before > 0 ? before : std::min(0.0, stiffness[p] * (gap - reach));
    }
    const std::vector<double> counts = sharing(surface, forces, model.rest_positions.size());
    for (std::uint32_t p = 0; p < piece.points; ++p) rows[piece.first_row + p] /= counts[p];
  }
  return rows;
}

}  // namespace fascia
