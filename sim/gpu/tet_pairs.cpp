#include "sim/gpu/tet_pairs.h"

#include <numeric>

namespace fascia {

TetPairs::TetPairs(const SimBuffers& buffers) {
  const auto tets = buffers.tet_vertices.read<Tet>();
  const std::uint32_t count = buffers.pair_and_single_count(), pair_count = buffers.pair_count;
  std::vector<Tet> corners(count);
  std::vector<std::uint32_t> fifth(count, 0), begin(buffers.vertex_count + 1, 0);
  for (std::uint32_t i = 0; i < count; ++i) {
    const bool two = i < pair_count;
    corners[i] = tets[two ? 2 * i : pair_count + i];
    for (const std::uint32_t v : corners[i]) ++begin[v + 1];
    if (!two) continue;
    fifth[i] = tets[2 * i + 1][3];
    ++begin[fifth[i] + 1];
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  slot_begin = gl::Buffer("pair_slot_begin", begin);
  std::vector<std::uint32_t>& next = begin;  // of each vertex the next free slot
  for (std::uint32_t i = 0; i < count; ++i) {
    for (std::uint32_t& v : corners[i]) v = next[v]++;
    if (i < pair_count) fifth[i] = next[fifth[i]]++;
  }
  slots = gl::Buffer("pair_slots", corners);
  fifth_slot = gl::Buffer("pair_fifth_slot", fifth);
}

gl::ComputePass::Bindings TetPairs::with_slots(gl::ComputePass::Bindings bindings) const {
  bindings.insert(bindings.end(), {{"pair_slots", &slots}, {"pair_fifth_slot", &fifth_slot}});
  return bindings;
}

}  // namespace fascia
