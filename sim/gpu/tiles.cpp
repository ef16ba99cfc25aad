#include "sim/gpu/tiles.h"

#include <algorithm>
#include <numeric>

namespace fascia {

Tiles::Tiles(const SimBuffers& buffers) {
  const std::uint32_t pairs = buffers.pair_and_single_count(), tiles = std::clamp(pairs / kLeastPairs, 1u, kMost);
  for (std::uint32_t k = 0; k <= tiles; ++k) pair_begin.push_back(static_cast<std::uint32_t>(std::uint64_t{pairs} * k / tiles));
  const auto tets = buffers.tet_vertices.read<Tet>();
  std::vector<std::uint32_t> last(buffers.vertex_count, 0), order(buffers.vertex_count);
  for (std::uint32_t k = 0, t = 0; k < tiles; ++k)
    for (std::uint32_t i = pair_begin[k]; i < pair_begin[k + 1]; ++i)
      for (const std::uint32_t end = t + (i < buffers.pair_count ? 2 : 1); t < end; ++t)
        for (const std::uint32_t v : tets[t]) last[v] = k;
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return last[a] < last[b]; });
  for (std::uint32_t k = 0; k <= tiles; ++k)
    vertex_begin.push_back(static_cast<std::uint32_t>(std::lower_bound(order.begin(), order.end(), k, [&](std::uint32_t v, std::uint32_t tile) { return last[v] < tile; }) - order.begin()));
  vertices = gl::Buffer("tile_vertices", order);
}

}  // namespace fascia
