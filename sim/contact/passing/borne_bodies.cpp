#include "sim/contact/passing/borne_bodies.h"

#include <algorithm>
#include <map>
#include <set>

#include "sim/contact/pair_row.h"
#include "sim/model/unconstrained_parts.h"

namespace fascia {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kPresses = 1e-6;  // of the largest normal force: less is what a body was pressed with
constexpr double kUnmoved = 1e-9;  // of a turn, and of the size of a place [m]

RigidPose way_of(const Tool& tool, std::size_t piece, const ToolMotion& motion, std::size_t index) {
  const RigidPose from = tool.pose_of_piece(piece, motion.from[index]);
  const RigidPose to = tool.pose_of_piece(piece, motion.to[index]);
  RigidPose way;
  way.axes = to.axes * from.axes.transpose();
  way.origin = to.origin - way.axes * from.origin;
  return way;
}

bool are_alike(const RigidPose& a, const RigidPose& b) {
  return (a.axes - b.axes).norm() < kUnmoved &&
         (a.origin - b.origin).norm() < kUnmoved * std::max({1e-3, a.origin.norm(), b.origin.norm()});
}

}  // namespace

BorneBodies::BorneBodies(const Model& model, const ContactSurface& contact)
    : model_(model), contact_(contact), part_of_(unconstrained_parts(model, model.held()).part) {}

std::vector<BorneBodies::Press> BorneBodies::presses(const ContactMemory& memory) const {
  std::vector<Press> found;
  if (memory.size() < contact_.row_count) return found;
  double largest = 0;
  for (std::uint32_t row = 0; row < contact_.row_count; ++row) largest = std::max(largest, memory[row].normal);
  for (std::uint32_t k = 0; k < contact_.pieces.size(); ++k) {
    const ContactPiece& piece = contact_.pieces[k];
    for (std::uint32_t p = 0; p < piece.points; ++p)
      if (memory[piece.first_row + p].normal > kPresses * largest)
        found.push_back({k, p, part_of_[contact_.points[p].vertices[0]]});
  }
  return found;
}

void BorneBodies::carry(const ContactMemory& memory, VectorXd& u, ToolMotion& motion) const {
  // What tissue presses, too, does not go with the tools alone.
  for (std::uint32_t slot = 0; contact_.row_count + memory_rows(slot + 1) <= memory.size(); ++slot)
    if (memory[contact_.row_count + force_row(slot)].normal > 0) return;
  std::map<std::uint32_t, std::set<std::uint32_t>> pieces_on;  // [part]
  std::map<std::uint32_t, std::set<std::uint32_t>> parts_of;   // [tool]
  for (const Press& press : presses(memory)) {
    pieces_on[press.part].insert(press.piece);
    parts_of[contact_.pieces[press.piece].tool].insert(press.part);
  }
  for (const auto& [part, pieces] : pieces_on) {
    if (part == 0) continue;
    std::vector<RigidPose> ways;
    bool alone = true;
    for (const std::uint32_t k : pieces) {
      const ContactPiece& piece = contact_.pieces[k];
      ways.push_back(way_of(model_.tools[piece.tool], piece.piece, motion, piece.tool));
      alone = alone && parts_of[piece.tool].size() == 1;
    }
    if (!alone || are_alike(ways[0], {}) ||
        std::any_of(ways.begin(), ways.end(), [&](const RigidPose& way) { return !are_alike(way, ways[0]); }))
      continue;
    for (std::size_t v = 0; v < part_of_.size(); ++v) {
      if (part_of_[v] != part) continue;
      auto moved = u.segment<3>(3 * static_cast<Eigen::Index>(v));
      const Vector3d place = model_.rest_positions[v] + moved;
      moved = ways[0].to_scene(place) - model_.rest_positions[v];
    }
    for (const std::uint32_t k : pieces) {
      const std::uint32_t tool = contact_.pieces[k].tool;
      motion.from[tool] = motion.to[tool];
    }
  }
}

}  // namespace fascia
