// A pair of places of the tissue that may touch in a step: a vertex and a face, or two edges.
#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>

#include "sim/model/state.h"

namespace fascia {

struct PairRow {
  /// Of the vertices: 0 those of the side that `normal` points to, 1 of the other.
  using Sides = std::array<std::uint8_t, 4>;
  static constexpr Sides kOfVertex{0, 1, 1, 1}, kOfEdges{0, 0, 1, 1};

  /// The gap is normal . sum_a weights[a] x[vertices[a]] - target; the weights of side 0 sum to 1, those of the other
  /// to -1. Beside a face or an end of an edge single ones have the other sign. The first vertex is free.
  std::array<std::uint32_t, 4> vertices{};
  std::array<double, 4> weights{};
  Sides sides = kOfVertex;
  Eigen::Vector3d normal{0, 0, 0};        // a unit vector, constant within the step
  Eigen::Vector3d start{0, 0, 0};         // sum_a weights[a] u[vertices[a]] at the start of the step [m]
  double gap = 0;                         // at the start [m], below 0 inside
  double stiffness = 0;                   // of the penalty on depth [N/m]
  double before = 0;                      // normal force that the step before left [N]
  std::uint32_t slot = 0;                 // that remembers its force
  std::uint32_t met = 0;                  // 1 + the triangle that the slot's vertex met, or the edge that its edge met
  std::array<std::uint32_t, 2> bodies{};  // in Model::bodies: the side that `normal` points to, and the other
};

/// The rows of State::contact that `slots` of pairs need, behind those of tools: after the forces of four slots comes a
/// row with what they met, so that pairs stay what they are from step to step.
inline std::uint32_t memory_rows(std::uint32_t slots) { return (slots + 3) / 4 * 5; }
inline std::uint32_t force_row(std::uint32_t slot) { return slot / 4 * 5 + slot % 4; }
inline std::uint32_t met_row(std::uint32_t slot) { return slot / 4 * 5 + 4; }
/// Of a row of ContactForce, or of one of the GPU's in its order.
inline double& met_in(ContactForce& row, std::uint32_t slot) {
  return slot % 4 < 3 ? row.friction[slot % 4] : row.normal;
}

}  // namespace fascia
