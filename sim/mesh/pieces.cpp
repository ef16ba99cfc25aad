#include "sim/mesh/pieces.h"

#include <algorithm>
#include <numeric>

namespace fascia {

std::vector<std::uint32_t> pieces_of(const std::vector<Tet>& tets, std::size_t vertex_count) {
  std::vector<std::uint32_t> lowest(vertex_count);  // a vertex of the same piece with a lower index, or itself
  std::iota(lowest.begin(), lowest.end(), 0u);
  const auto root_of = [&](std::uint32_t v) {
    while (lowest[v] != v) v = lowest[v] = lowest[lowest[v]];
    return v;
  };
  for (const Tet& tet : tets)
    for (const std::uint32_t v : tet) {
      const auto [low, high] = std::minmax({root_of(tet[0]), root_of(v)});
      lowest[high] = low;
    }
  std::vector<std::uint32_t> piece(vertex_count);
  std::uint32_t count = 0;
  for (std::uint32_t v = 0; v < vertex_count; ++v) piece[v] = lowest[v] == v ? count++ : piece[root_of(v)];
  return piece;
}

}  // namespace fascia
