#include "sim/coarse/coarse_gather.h"

#include <Eigen/LU>
#include <algorithm>
#include <numeric>

namespace fascia {
namespace {

using Eigen::Vector3d;
constexpr double kInner = 0.5;  // of the largest share that a tet has in a node's rotation

}  // namespace

CoarseTranspose transpose(const CoarseSpace& space) {
  CoarseTranspose rows;
  rows.begin.assign(space.node_count + 1, 0);
  for (const std::uint32_t node : space.node) ++rows.begin[node + 1];
  std::partial_sum(rows.begin.begin(), rows.begin.end(), rows.begin.begin());
  rows.vertex.resize(space.node.size());
  rows.weight.resize(space.node.size());
  std::vector<std::uint32_t> next(rows.begin.begin(), rows.begin.end() - 1);
  for (std::uint32_t v = 0; v + 1 < space.begin.size(); ++v)
    for (std::uint32_t k = space.begin[v]; k < space.begin[v + 1]; ++k) {
      const std::uint32_t at = next[space.node[k]]++;
      rows.vertex[at] = v;
      rows.weight[at] = space.weight[k];
    }
  return rows;
}

CoarseGather make_coarse_gather(const Model& model, const CoarseSpace& space) {
  struct Entry {
    std::uint32_t node;
    Vector3d gradient;
  };
  const std::size_t vertex_count = model.rest_positions.size();
  std::vector<std::vector<Entry>> rows(vertex_count);
  const auto entry = [&](std::uint32_t v, std::uint32_t node) -> Entry& {
    for (Entry& e : rows[v])
      if (e.node == node) return e;
    return rows[v].emplace_back(Entry{node, Vector3d::Zero()});
  };
  std::vector<double> sum(space.node_count, 0), largest(space.node_count, 0);
  std::vector<std::pair<std::uint32_t, double>> share;  // node, sum of the corners' weights times the stiffness
  const auto find_share = [&](std::size_t t) {
    share.clear();
    for (const std::uint32_t v : model.tets[t])
      for (std::uint32_t k = space.begin[v]; k < space.begin[v + 1]; ++k) {
        const auto same =
            std::find_if(share.begin(), share.end(), [&](const auto& s) { return s.first == space.node[k]; });
        if (same == share.end())
          share.emplace_back(space.node[k], space.weight[k]);
        else
          same->second += space.weight[k];
      }
    for (auto& [node, s] : share) s *= model.materials[model.tet_material[t]].young_modulus;
  };
  for (std::size_t t = 0; t < model.tets.size(); ++t) {
    find_share(t);
    for (const auto& [node, s] : share) largest[node] = std::max(largest[node], s);
  }
  for (std::size_t t = 0; t < model.tets.size(); ++t) {
    const Tet& tet = model.tets[t];
    find_share(t);
    Eigen::Matrix3d dm;
    for (int k = 0; k < 3; ++k) dm.col(k) = model.rest_positions[tet[k + 1]] - model.rest_positions[tet[0]];
    const Eigen::Matrix3d inv_dm = dm.inverse();
    const double v = dm.determinant() / 6;
    for (const auto& [node, s] : share) {
      if (s < kInner * largest[node]) continue;
      sum[node] += v * s;
      for (int a = 0; a < 4; ++a) {
        const Vector3d b =
            a == 0 ? Vector3d(-inv_dm.colwise().sum().transpose()) : Vector3d(inv_dm.row(a - 1).transpose());
        entry(tet[static_cast<std::size_t>(a)], node).gradient += v * s * b;
      }
    }
  }

  CoarseGather gather;
  gather.begin.assign(space.node_count + 1, 0);
  for (const auto& row : rows)
    for (const Entry& e : row) ++gather.begin[e.node + 1];
  std::partial_sum(gather.begin.begin(), gather.begin.end(), gather.begin.begin());
  gather.vertex.resize(gather.begin.back());
  gather.gradient.resize(gather.begin.back());
  std::vector<std::uint32_t> next(gather.begin.begin(), gather.begin.end() - 1);
  for (std::uint32_t v = 0; v < vertex_count; ++v)
    for (const Entry& e : rows[v]) {
      const std::uint32_t at = next[e.node]++;
      gather.vertex[at] = v;
      gather.gradient[at] = e.gradient / sum[e.node];
    }
  return gather;
}

}  // namespace fascia
