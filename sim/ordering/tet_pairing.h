// Tets in pairs that share a face: who goes through pairs meets five vertices instead of eight.
#pragma once
#include <cstdint>
#include <vector>

#include "sim/mesh/tet_mesh.h"

namespace fascia {

struct TetPairing {
  // The tets: the first one of every pair, then those that are by themselves, then the second one of every pair. Who
  // reads more of the first ones (shaders/common/tet_pair.glsl) finds that side by side.
  std::vector<std::uint32_t> order;
  std::uint32_t pair_count = 0;
  std::size_t second_begin() const { return order.size() - pair_count; }
};

/// Pairs as many of the tets `order` (indices into `tets`) as a greedy matching does that takes first who has the
/// fewest to choose from (Karp and Sipser 1981): all but a few percent. Pairs, and the single tets, come in the order
/// that is given.
TetPairing pair_tets(const std::vector<Tet>& tets, const std::vector<std::uint32_t>& order);

/// Turns the corners of two tets of positive volume that share a face, their orientation kept, so that they are (s0,
/// s1, s2, x) and (s0, s2, s1, y). False, and nothing is changed, where they do not lie on the two sides of a common
/// face.
bool align_at_face(Tet& a, Tet& b);

}  // namespace fascia
