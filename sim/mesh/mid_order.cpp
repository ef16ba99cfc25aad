#include "sim/mesh/mid_order.h"

#include <algorithm>
#include <array>

#include "base/error.h"
#include "base/text.h"

namespace fascia {
namespace {

using Eigen::Vector3d;
using Order = std::array<std::size_t, 6>;  // [edge] place of its vertex in what the file has

constexpr Order kAsGiven = {0, 1, 2, 3, 4, 5};
constexpr double kNear = 0.25;    // of the edge: the arc of a curved one reaches farther at more than a third of a turn
constexpr double kTooFar = 0.5;   // of the tet's longest edge: no arc reaches that far
constexpr double kClearly = 0.5;  // of the squared distances as given, that another order must stay below

using Costs = std::array<std::array<double, 6>, 6>;  // [edge][place] squared distance of the vertex to its middle

double sum(const Costs& costs, const Order& order) {
  double sum = 0;
  for (std::size_t m = 0; m < 6; ++m) sum += costs[m][order[m]];
  return sum;
}

/// The order of the least sum, if that is clearly another one than that of the file.
Order best_order(const Costs& costs) {
  Order order = kAsGiven, best = kAsGiven;
  double least = kClearly * sum(costs, kAsGiven);
  while (std::next_permutation(order.begin(), order.end()))
    if (const double here = sum(costs, order); here < least) {
      least = here;
      best = order;
    }
  return best;
}

void put_in(const Order& order, MidEdges& given) {
  const MidEdges old = given;
  for (std::size_t m = 0; m < 6; ++m) given[m] = old[order[m]];
}

/// A quadratic tet with all of its middle vertices.
struct QuadraticTet {
  Costs costs{};
  double longest = 0;   // edge
  bool is_near = true;  // every vertex at its own edge

  QuadraticTet(const std::vector<Vector3d>& x, const Tet& tet, const MidEdges& given) {
    for (std::size_t m = 0; m < 6; ++m) {
      const Vector3d middle = middle_of(x, tet, m);
      const double length = 2 * (x[tet[kMidEdgeCorners[m][0]]] - middle).norm();
      longest = std::max(longest, length);
      for (std::size_t n = 0; n < 6; ++n) costs[m][n] = (x[given[n]] - middle).squaredNorm();
      is_near &= costs[m][m] <= kNear * kNear * length * length;
    }
  }
  static Vector3d middle_of(const std::vector<Vector3d>& x, const Tet& tet, std::size_t m) {
    return 0.5 * (x[tet[kMidEdgeCorners[m][0]]] + x[tet[kMidEdgeCorners[m][1]]]);
  }

  /// The edge from whose middle its vertex is farthest.
  std::size_t worst(const Order& order) const {
    return *std::max_element(kAsGiven.begin(), kAsGiven.end(),
                             [&](std::size_t a, std::size_t b) { return costs[a][order[a]] < costs[b][order[b]]; });
  }
  bool is_within(double lengths, const Order& order) const {
    const std::size_t m = worst(order);
    return costs[m][order[m]] <= lengths * lengths * longest * longest;
  }
};

/// The order that most of the tets have: in flat tets with curved edges that of one alone may not be clear.
Order order_of_all(const TetMesh& mesh, const std::vector<std::uint32_t>& tets, const std::vector<MidEdges>& given) {
  Costs costs{};
  bool all_near = true;
  for (const std::uint32_t t : tets) {
    const QuadraticTet tet(mesh.positions, mesh.tets[t], given[t]);
    all_near &= tet.is_near;
    for (std::size_t m = 0; m < 6; ++m)
      for (std::size_t n = 0; n < 6; ++n) costs[m][n] += tet.costs[m][n] / (tet.longest * tet.longest);
  }
  return all_near ? kAsGiven : best_order(costs);
}

constexpr const char* kExpected =
    "expected quadratic tets with six vertices at the middles of their edges, or elements=linear, which uses the "
    "corners alone";

std::string use_of(const TetMesh& mesh, std::uint32_t tet, std::uint32_t vertex, std::size_t m) {
  return "tet " + std::to_string(tet) + " has vertex " + std::to_string(vertex) + " at " +
         point(mesh.positions[vertex]) + " for the middle of the edge at " +
         point(QuadraticTet::middle_of(mesh.positions, mesh.tets[tet], m));
}

}  // namespace

void require_own_middles(const TetMesh& mesh, const std::vector<std::uint32_t>& tets,
                         const std::vector<MidEdges>& given, const std::string& where) {
  struct Use {
    std::uint32_t tet = kNoVertex;
    std::size_t m = 0;
  };
  std::vector<Use> uses(mesh.positions.size());
  std::vector<char> is_corner(mesh.positions.size(), 0);
  for (const std::uint32_t t : tets)
    for (const std::uint32_t v : mesh.tets[t]) is_corner[v] = 1;
  const auto edge = [&](const Use& use) {
    const Tet& tet = mesh.tets[use.tet];
    return std::minmax(tet[kMidEdgeCorners[use.m][0]], tet[kMidEdgeCorners[use.m][1]]);
  };
  for (const std::uint32_t t : tets) {
    if (t >= given.size()) continue;
    for (std::size_t m = 0; m < kMidEdgeCorners.size(); ++m) {
      const std::uint32_t v = given[t][m];
      if (v == kNoVertex) continue;
      if (is_corner[v]) throw Error(where, use_of(mesh, t, v, m) + ", and it is a corner of a tet", kExpected);
      if (uses[v].tet == kNoVertex) uses[v] = {t, m};
      if (edge(uses[v]) != edge({t, m}))
        throw Error(where,
                    use_of(mesh, t, v, m) + ", and tet " + std::to_string(uses[v].tet) + " for that at " +
                        point(QuadraticTet::middle_of(mesh.positions, mesh.tets[uses[v].tet], uses[v].m)),
                    kExpected);
    }
  }
}

std::size_t order_mid_edges(const TetMesh& mesh, const std::vector<std::uint32_t>& tets, std::vector<MidEdges>& given,
                            const std::string& where) {
  std::vector<std::uint32_t> whole;  // with six vertices
  for (const std::uint32_t t : tets)
    if (t < given.size() && std::find(given[t].begin(), given[t].end(), kNoVertex) == given[t].end())
      whole.push_back(t);
  const Order common = order_of_all(mesh, whole, given);
  std::size_t reordered = 0;
  for (const std::uint32_t t : whole) {
    const MidEdges old = given[t];
    put_in(common, given[t]);
    const QuadraticTet tet(mesh.positions, mesh.tets[t], given[t]);
    if (!tet.is_near) {
      const Order own = best_order(tet.costs);
      if (tet.is_within(kNear, own)) put_in(own, given[t]);
    }
    reordered += given[t] != old;
    const QuadraticTet settled(mesh.positions, mesh.tets[t], given[t]);
    if (settled.is_within(kTooFar, kAsGiven)) continue;
    const std::size_t m = settled.worst(kAsGiven);
    throw Error(where, use_of(mesh, t, given[t][m], m), kExpected);
  }
  return reordered;
}

}  // namespace fascia
