// A pair of places of the tissue that may touch in a step: a vertex and a face, or two edges.
#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>

namespace fascia {

struct PairRow {
  /// The gap is normal . sum_a weights[a] x[vertices[a]] - target; the weights sum to 0, those above 0 are of the side
  /// that `normal` points to. The first vertex is free.
  std::array<std::uint32_t, 4> vertices{};
  std::array<double, 4> weights{};
  Eigen::Vector3d normal{0, 0, 0};        // a unit vector, constant within the step
  Eigen::Vector3d start{0, 0, 0};         // sum_a weights[a] u[vertices[a]] at the start of the step [m]
  double gap = 0;                         // at the start [m], below 0 inside
  double stiffness = 0;                   // of the penalty on depth [N/m]
  double before = 0;                      // normal force that the step before left [N]
  std::uint32_t slot = 0;                 // of its force in the memory of contact, from PairSearch's first one on
  std::array<std::uint32_t, 2> bodies{};  // in Model::bodies: the side that `normal` points to, and the other
};

}  // namespace fascia
