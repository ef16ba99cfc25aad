// The pairs of tets in parts that follow each other along the curve, and behind each part the vertices for which it was the last one: what
// pairs leave in their slots is gathered while it still is in the cache. A vertex that is moved at once is read by no later pair.
#pragma once
#include <cstdint>
#include <vector>

#include "sim/gpu/sim_buffers.h"

namespace fascia {

struct Tiles {
  static constexpr std::uint32_t kLeastPairs = 8192;  // of a tile: 650 kB of slots
  static constexpr std::uint32_t kMost = 64;          // tiles: each is three kernels of a fused dispatch
  /// With the tets in the order they have now.
  explicit Tiles(const SimBuffers& buffers);
  std::uint32_t count() const { return static_cast<std::uint32_t>(pair_begin.size() - 1); }

  std::vector<std::uint32_t> pair_begin;    // [count + 1] in pairs and single tets
  std::vector<std::uint32_t> vertex_begin;  // [count + 1] in `vertices`
  gl::Buffer vertices;                      // uint [vertex_count]
};

}  // namespace fascia
