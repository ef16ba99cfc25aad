#include "sim/ordering/morton_order.h"

#include <algorithm>
#include <numeric>

namespace fascia {
namespace {

constexpr int kBits = 10;  // per axis

// Puts two zero bits between neighboring bits.
std::uint32_t spread(std::uint32_t v) {
  v = (v | v << 16) & 0x030000ffu;
  v = (v | v << 8) & 0x0300f00fu;
  v = (v | v << 4) & 0x030c30c3u;
  return (v | v << 2) & 0x09249249u;
}

}  // namespace

std::vector<std::uint32_t> curve_order(const std::vector<Eigen::Vector3d>& positions, const std::vector<Tet>& tets) {
  Eigen::Vector3d least = Eigen::Vector3d::Constant(1e300), most = -least;
  for (const Tet& tet : tets)
    for (const std::uint32_t v : tet) {
      least = least.cwiseMin(positions[v]);
      most = most.cwiseMax(positions[v]);
    }
  const double side = tets.empty() ? 0 : (most - least).maxCoeff();
  const double scale = side > 0 ? ((1 << kBits) - 1) / side : 0;
  std::vector<std::uint32_t> code(tets.size()), order(tets.size());
  for (std::size_t t = 0; t < tets.size(); ++t) {
    const Tet& tet = tets[t];
    const Eigen::Vector3d center =
        0.25 * (positions[tet[0]] + positions[tet[1]] + positions[tet[2]] + positions[tet[3]]);
    const Eigen::Vector3d cell = scale * (center - least);
    for (int axis = 0; axis < 3; ++axis) code[t] |= spread(static_cast<std::uint32_t>(cell[axis])) << axis;
  }
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return code[a] < code[b]; });
  return order;
}

std::vector<std::uint32_t> solved_tets(const Model& model) {
  std::vector<char> fixed(model.rest_positions.size(), 0);
  for (const std::uint32_t vertex : model.fixed) fixed[vertex] = 1;
  std::vector<std::uint32_t> order = curve_order(model.rest_positions, model.tets);
  std::erase_if(order, [&](std::uint32_t t) {
    const Tet& tet = model.tets[t];
    return std::all_of(tet.begin(), tet.end(), [&](std::uint32_t v) { return fixed[v] != 0; });
  });
  return order;
}

TetPairing paired_tets(const Model& model) {
  std::vector<std::uint32_t> linear = solved_tets(model), quadratic;
  const auto first_quadratic =
      std::stable_partition(linear.begin(), linear.end(), [&](std::uint32_t t) { return !model.is_quadratic(t); });
  quadratic.assign(first_quadratic, linear.end());
  linear.erase(first_quadratic, linear.end());
  TetPairing pairing = pair_tets(model.tets, linear);
  const auto volume = [&](std::uint32_t t) {
    const auto edge = [&](int k) -> Eigen::Vector3d {
      return model.rest_positions[model.tets[t][k]] - model.rest_positions[model.tets[t][0]];
    };
    return edge(1).cross(edge(2)).dot(edge(3));
  };
  for (std::size_t i = 0; i < pairing.pair_count; ++i) {
    std::uint32_t &first = pairing.order[i], &second = pairing.order[pairing.second_begin() + i];
    if (volume(first) < volume(second)) std::swap(first, second);
  }
  pairing.order.insert(pairing.order.end(), quadratic.begin(), quadratic.end());
  pairing.quadratic_count = static_cast<std::uint32_t>(quadratic.size());
  return pairing;
}

}  // namespace fascia
