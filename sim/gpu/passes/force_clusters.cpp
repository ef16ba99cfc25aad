#include "sim/gpu/passes/force_clusters.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace fascia {
namespace {

struct Corner {
  std::uint32_t vertex, entry;  // 64 * corner + pair within the cluster
};

// The corners of the pairs of a cluster, sorted by vertex.
std::vector<Corner> corners_of(const SimBuffers& buffers, std::uint32_t cluster) {
  constexpr std::uint32_t kPairs = ForceClusters::kPairs;
  const std::uint32_t begin = kPairs * cluster, end = std::min(begin + kPairs, buffers.pair_and_single_count());
  std::vector<Corner> corners;
  corners.reserve(5 * kPairs);
  for (std::uint32_t i = begin; i < end; ++i) {
    for (std::uint32_t k = 0; k < 4; ++k) corners.push_back({buffers.tets[i][k], kPairs * k + i - begin});
    if (i < buffers.pair_count)
      corners.push_back({buffers.tets[buffers.pair_and_single_count() + i][3], kPairs * 4 + i - begin});
  }
  std::sort(corners.begin(), corners.end(), [](const Corner& a, const Corner& b) {
    return std::pair(a.vertex, a.entry) < std::pair(b.vertex, b.entry);
  });
  return corners;
}

// Calls f(vertex, first, end) for the corners of each vertex.
template <class F>
void for_vertices(const std::vector<Corner>& corners, F&& f) {
  for (std::size_t first = 0, end = 0; first < corners.size(); first = end) {
    while (end < corners.size() && corners[end].vertex == corners[first].vertex) ++end;
    f(corners[first].vertex, static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(end));
  }
}

}  // namespace

bool ForceClusters::serve(const gl::ProgramCache& programs, const SimBuffers& buffers) {
  return programs.sums_in_groups() && !buffers.has_quadratic();
}

ForceClusters::ForceClusters(const SimBuffers& buffers) : pairs_(buffers.pair_and_single_count()) {
  std::vector<std::uint32_t> begins(buffers.vertex_count + 1, 0);
  for (std::uint32_t c = 0; c < count(); ++c)
    for_vertices(corners_of(buffers, c), [&](std::uint32_t vertex, auto, auto) { ++begins[vertex + 1]; });
  std::partial_sum(begins.begin(), begins.end(), begins.begin());
  slot_begin_ = gl::Buffer("cluster_slot_begin", begins);
  forces_ = gl::Buffer("cluster_forces", sizeof(shared::vec4) * std::max(1u, begins.back()));
  forces_.clear();

  std::vector<std::uint32_t>& next = begins;  // next free slot of each vertex
  std::vector<std::uint32_t> lists(count());
  for (std::uint32_t c = 0; c < count(); ++c) {
    const std::vector<Corner> corners = corners_of(buffers, c);
    lists[c] = static_cast<std::uint32_t>(lists.size());
    lists.push_back(0);
    for_vertices(corners, [&](std::uint32_t vertex, std::uint32_t first, std::uint32_t end) {
      ++lists[lists[c]];
      lists.insert(lists.end(), {next[vertex]++, first | (end - first) << 16});
    });
    for (std::size_t k = 0; k < corners.size(); ++k) {
      if (k % 3 == 0) lists.push_back(0);
      lists.back() |= corners[k].entry << 10 * (k % 3);
    }
  }
  if (lists.empty()) lists.push_back(0);
  lists_ = gl::Buffer("clusters", lists);
}

std::vector<std::uint32_t> clusters_of(const std::vector<std::uint32_t>& pairs) {
  constexpr std::uint32_t kPairs = ForceClusters::kPairs;
  std::vector<std::uint32_t> clusters;
  for (const std::uint32_t pair : pairs) {
    if (clusters.empty() || clusters[clusters.size() - 3] != pair / kPairs)
      clusters.insert(clusters.end(), {pair / kPairs, 0, 0});
    clusters[clusters.size() - 2 + pair % kPairs / 32] |= 1u << pair % 32;
  }
  return clusters;
}

}  // namespace fascia
