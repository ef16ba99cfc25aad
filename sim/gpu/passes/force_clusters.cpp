#include "sim/gpu/passes/force_clusters.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace fascia {
namespace {

// The corners of the pairs of a cluster by vertex, ascending: 64 * corner + pair within the cluster.
using Corners = std::map<std::uint32_t, std::vector<std::uint32_t>>;

Corners corners_of(const SimBuffers& buffers, std::uint32_t cluster) {
  constexpr std::uint32_t kPairs = ForceClusters::kPairs;
  const std::uint32_t begin = kPairs * cluster, end = std::min(begin + kPairs, buffers.pair_and_single_count());
  Corners corners;
  for (std::uint32_t i = begin; i < end; ++i) {
    for (std::uint32_t k = 0; k < 4; ++k) corners[buffers.tets[i][k]].push_back(kPairs * k + i - begin);
    if (i < buffers.pair_count)
      corners[buffers.tets[buffers.pair_and_single_count() + i][3]].push_back(kPairs * 4 + i - begin);
  }
  return corners;
}

}  // namespace

bool ForceClusters::serve(const gl::ProgramCache& programs, const SimBuffers& buffers) {
  return programs.load_path() == gl::LoadPath::storage && !buffers.has_quadratic();
}

ForceClusters::ForceClusters(const SimBuffers& buffers) : pairs_(buffers.pair_and_single_count()) {
  std::vector<Corners> clusters;
  std::vector<std::uint32_t> begins(buffers.vertex_count + 1, 0);
  for (std::uint32_t c = 0; c < count(); ++c) {
    clusters.push_back(corners_of(buffers, c));
    for (const auto& [vertex, corners] : clusters.back()) ++begins[vertex + 1];
  }
  std::partial_sum(begins.begin(), begins.end(), begins.begin());
  slot_begin_ = gl::Buffer("cluster_slot_begin", begins);
  forces_ = gl::Buffer("cluster_forces", sizeof(shared::vec4) * std::max(1u, begins.back()));
  forces_.clear();

  std::vector<std::uint32_t>& next = begins;  // next free slot of each vertex
  std::vector<std::uint32_t> lists(clusters.size());
  for (std::size_t c = 0; c < clusters.size(); ++c) {
    lists[c] = static_cast<std::uint32_t>(lists.size());
    lists.push_back(static_cast<std::uint32_t>(clusters[c].size()));
    std::vector<std::uint32_t> all;
    for (const auto& [vertex, corners] : clusters[c]) {
      lists.push_back(next[vertex]++);
      lists.push_back(static_cast<std::uint32_t>(all.size() | corners.size() << 16));
      all.insert(all.end(), corners.begin(), corners.end());
    }
    all.resize(all.size() + all.size() % 2);
    for (std::size_t k = 0; k < all.size(); k += 2) lists.push_back(all[k] | all[k + 1] << 16);
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
