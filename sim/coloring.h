// Colors for tets so that no two tets of a color share a free vertex: each color can be solved in place, in parallel.
#pragma once
#include <cstdint>
#include <vector>

#include "sim/tet_mesh.h"

namespace fascia {

struct Coloring {
  std::vector<std::uint32_t> order;  // [tet_count] tets sorted by color, ascending within a color
  std::vector<std::uint32_t> begin;  // [color_count + 1] where each color starts in `order`
  std::size_t color_count() const { return begin.empty() ? 0 : begin.size() - 1; }
};

/// Greedy first fit in the order of the tets, then tets of large colors move to the smallest color that takes them, so that
/// no dispatch is tiny. Held vertices (`held` [vertex_count], 1 where held) make no conflicts. Same input, same coloring.
Coloring color_tets(const std::vector<Tet>& tets, const std::vector<char>& held);

}  // namespace fascia
