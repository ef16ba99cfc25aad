// Linear tets in pairs that share a face: a pair references five vertices instead of eight. Quadratic tets stay single.
#pragma once
#include <cstdint>
#include <vector>

#include "sim/mesh/tet_mesh.h"

namespace fascia {

struct TetPairing {
  // The tets: the first one of every pair, then the single ones, then the second one of every pair, then the quadratic
  // ones. A kernel that reads more data of the first ones (shaders/common/tet_pair.glsl) finds it contiguous.
  std::vector<std::uint32_t> order;
  std::uint32_t pair_count = 0, quadratic_count = 0;
  std::size_t linear_count() const { return order.size() - quadratic_count; }
  std::size_t second_begin() const { return linear_count() - pair_count; }
};

/// Pairs as many of the tets `order` (indices into `tets`) as a greedy matching does that starts with the tets of
/// fewest choices (Karp and Sipser 1981): all but a few percent. Pairs and single tets come in the given order.
TetPairing pair_tets(const std::vector<Tet>& tets, const std::vector<std::uint32_t>& order);

/// Permutes the corners of two tets of positive volume that share a face, preserving orientation, to (s0, s1, s2, x)
/// and (s0, s2, s1, y). False, without changes, if they do not lie on the two sides of a common face.
bool align_at_face(Tet& a, Tet& b);

}  // namespace fascia
