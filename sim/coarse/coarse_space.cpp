#include "sim/coarse/coarse_space.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace fascia {
namespace {

using Eigen::Vector3d;
constexpr double kWeakNode = 0.1;         // of the mean mass
constexpr double kLeastWeight = 1e-12;    // below it a lattice corner is ignored
constexpr double kEnough = 0.85;          // of the requested nodes
constexpr int kMostCoarseCells = 100;     // along an axis
constexpr std::uint32_t kNeighbors = 64;  // nodes in each group that is sorted by number of entries
constexpr double kCoarsened = 1.5;        // cells of a lattice that was too fine, in cells of the mesh
constexpr std::size_t kFewVertices = 24;  // below it there would be more lattice nodes than vertices

struct CoarseLattice {
  Vector3d low, extent;
  std::array<int, 3> cells{1, 1, 1};

  std::size_t nodes() const { return std::size_t{node_row(0)} * node_row(1) * node_row(2); }
  std::uint32_t node_row(unsigned k) const { return static_cast<std::uint32_t>(cells[k]) + 1; }
  struct Corner {
    std::uint32_t node;
    double weight;
  };
  std::array<Corner, 8> corners(const Vector3d& x) const {
    std::array<int, 3> cell;
    Vector3d part;
    for (int k = 0; k < 3; ++k) {
      const double at = extent[k] > 0 ? (x[k] - low[k]) / extent[k] * cells[k] : 0;
      cell[k] = std::clamp(static_cast<int>(at), 0, cells[k] - 1);
      part[k] = at - cell[k];
    }
    std::array<Corner, 8> found;
    for (unsigned c = 0; c < 8; ++c) {
      found[c] = {0, 1};
      for (unsigned k = 0; k < 3; ++k) {
        const unsigned upper = c >> k & 1u;
        found[c].weight *= upper ? part[k] : 1 - part[k];
        found[c].node = found[c].node * node_row(k) + static_cast<unsigned>(cell[k]) + upper;
      }
    }
    return found;
  }
};

struct Edges {  // of the mesh between free vertices, by rows
  std::vector<std::uint32_t> begin, other;
};

/// [vertex_count] The stiffest material around each vertex.
std::vector<std::uint32_t> stiffest_materials(const Model& model) {
  std::vector<std::uint32_t> stiffest(model.rest_positions.size(), 0);
  std::vector<double> modulus(stiffest.size(), 0);
  for (std::size_t t = 0; t < model.tets.size(); ++t)
    for (const std::uint32_t v : model.tets[t])
      if (const double e = model.materials[model.tet_material[t]].young_modulus; e > modulus[v]) {
        modulus[v] = e;
        stiffest[v] = model.tet_material[t];
      }
  return stiffest;
}

/// With `cut_materials` only edges between vertices of the same material.
Edges free_edges(const Model& model, const std::vector<char>& held, bool cut_materials) {
  const std::vector<std::uint32_t> material =
      cut_materials ? stiffest_materials(model) : std::vector<std::uint32_t>(model.rest_positions.size(), 0);
  Edges edges;
  edges.begin.assign(model.rest_positions.size() + 1, 0);
  const auto each = [&](auto&& f) {
    for (const Tet& tet : model.tets)
      for (const std::uint32_t a : tet)
        for (const std::uint32_t b : tet)
          if (a != b && !held[a] && !held[b] && material[a] == material[b]) f(a, b);
  };
  each([&](std::uint32_t a, std::uint32_t) { ++edges.begin[a + 1]; });
  std::partial_sum(edges.begin.begin(), edges.begin.end(), edges.begin.begin());
  edges.other.resize(edges.begin.back());
  std::vector<std::uint32_t> next(edges.begin.begin(), edges.begin.end() - 1);
  each([&](std::uint32_t a, std::uint32_t b) { edges.other[next[a]++] = b; });
  return edges;
}

/// The pieces of `members` that are connected by edges between members: [members] number of the piece of each. `local`
/// [vertex_count] is scratch, all -1 before and after.
std::vector<std::uint32_t> pieces(const std::vector<std::uint32_t>& members, const Edges& edges,
                                  std::vector<int>& local, std::uint32_t& count) {
  for (std::size_t i = 0; i < members.size(); ++i) local[members[i]] = static_cast<int>(i);
  constexpr std::uint32_t kNone = ~0u;
  std::vector<std::uint32_t> piece(members.size(), kNone), stack;
  count = 0;
  for (std::uint32_t i = 0; i < members.size(); ++i) {
    if (piece[i] != kNone) continue;
    piece[i] = count;
    stack.assign(1, i);
    while (!stack.empty()) {
      const std::uint32_t v = members[stack.back()];
      stack.pop_back();
      for (std::uint32_t e = edges.begin[v]; e < edges.begin[v + 1]; ++e) {
        const int j = local[edges.other[e]];
        if (j < 0 || piece[static_cast<std::size_t>(j)] != kNone) continue;
        piece[static_cast<std::size_t>(j)] = count;
        stack.push_back(static_cast<std::uint32_t>(j));
      }
    }
    ++count;
  }
  for (const std::uint32_t v : members) local[v] = -1;
  return piece;
}

/// Cells as close to cubes as the box allows, with about `target` lattice nodes that have a vertex in reach.
CoarseLattice fit_lattice(const std::vector<Vector3d>& positions, const std::vector<std::uint32_t>& free,
                          std::uint32_t target) {
  CoarseLattice lattice;
  Vector3d high = positions[free.front()];
  lattice.low = high;
  for (const std::uint32_t v : free) {
    lattice.low = lattice.low.cwiseMin(positions[v]);
    high = high.cwiseMax(positions[v]);
  }
  lattice.extent = high - lattice.low;
  const double longest = lattice.extent.maxCoeff();
  const auto with_cell = [&](double size) {
    CoarseLattice l = lattice;
    for (int k = 0; k < 3; ++k)
      l.cells[k] = std::clamp(static_cast<int>(std::lround(l.extent[k] / size)), 1, kMostCoarseCells);
    return l;
  };
  std::vector<char> reached;
  const auto nodes_of = [&](const CoarseLattice& l) {
    reached.assign(l.nodes(), 0);
    std::uint32_t count = 0;
    for (const std::uint32_t v : free)
      for (const CoarseLattice::Corner& c : l.corners(positions[v]))
        if (c.weight > kLeastWeight && !reached[c.node]) {
          reached[c.node] = 1;
          ++count;
        }
    return static_cast<double>(count);
  };
  double small = longest / kMostCoarseCells, large = 2 * longest;
  CoarseLattice tried = with_cell(large), best = tried;
  double nodes = nodes_of(tried), best_miss = std::abs(nodes - target);
  for (int i = 0; i < 14; ++i) {
    const double size = std::sqrt(small * large);
    if (const CoarseLattice l = with_cell(size); l.cells != tried.cells) {
      tried = l;
      nodes = nodes_of(tried);
    }
    if (std::abs(nodes - target) < best_miss) {
      best_miss = std::abs(nodes - target);
      best = tried;
    }
    (nodes > target ? small : large) = size;
  }
  return best;
}

/// For each part of the mesh the lattice, made coarser along an axis where its cells would be smaller than those of the
/// part's mesh: several lattice nodes would then see the same vertices, and their functions depend on each other.
std::vector<CoarseLattice> part_lattices(const CoarseLattice& lattice, const Model& model, const Edges& edges,
                                         const std::vector<std::uint32_t>& part, std::uint32_t part_count) {
  std::vector<CoarseLattice> lattices(part_count, lattice);
  if (part_count == 1) return lattices;
  constexpr double kCellOfEdges = 1.75;  // in a cube of six tets, four of seven edges are as long as it along an axis
  std::vector<Vector3d> sum(part_count, Vector3d::Zero());
  std::vector<double> count(part_count, 0);
  for (std::uint32_t v = 0; v + 1 < edges.begin.size(); ++v)
    for (std::uint32_t e = edges.begin[v]; e < edges.begin[v + 1]; ++e) {
      sum[part[v]] += (model.rest_positions[edges.other[e]] - model.rest_positions[v]).cwiseAbs();
      ++count[part[v]];
    }
  for (std::uint32_t p = 0; p < part_count; ++p)
    for (int k = 0; k < 3; ++k) {
      const double cell = count[p] > 0 ? kCellOfEdges * sum[p][k] / count[p] : 0;
      if (cell * lattice.cells[k] > lattice.extent[k])
        lattices[p].cells[k] = std::max(1, static_cast<int>(lattice.extent[k] / (kCoarsened * cell)));
    }
  return lattices;
}

/// Numbers nodes in the order of the vertices in their reach, so that neighboring invocations read neighboring data.
/// Then, among neighbors, nodes with equal numbers of vertices are adjacent: invocations in lockstep take as long as
/// the longest of them.
void order_nodes(CoarseSpace& space) {
  const std::uint32_t n = space.node_count;
  std::vector<std::uint32_t> entries(n, 0), order(n), number(n);
  std::vector<double> middle(n, 0), total(n, 0);
  for (std::uint32_t v = 0; v + 1 < space.begin.size(); ++v)
    for (std::uint32_t k = space.begin[v]; k < space.begin[v + 1]; ++k) {
      ++entries[space.node[k]];
      middle[space.node[k]] += space.weight[k] * v;
      total[space.node[k]] += space.weight[k];
    }
  for (std::uint32_t j = 0; j < n; ++j)
    if (total[j] > 0) middle[j] /= total[j];
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return middle[a] < middle[b]; });
  for (std::uint32_t first = 0; first < n; first += kNeighbors)
    std::stable_sort(order.begin() + first, order.begin() + std::min(n, first + kNeighbors),
                     [&](std::uint32_t a, std::uint32_t b) { return entries[a] > entries[b]; });
  for (std::uint32_t j = 0; j < n; ++j) number[order[j]] = j;
  for (std::uint32_t& node : space.node) node = number[node];
}

/// A space of about `target` lattice nodes and at most `most` functions. If that is too few for all parts of the mesh,
/// the lightest get none and `complete` becomes false.
CoarseSpace lattice_space(const Model& model, const std::vector<std::uint32_t>& free, const Edges& edges,
                          std::uint32_t target, std::uint32_t most, bool& complete) {
  const std::size_t vertex_count = model.rest_positions.size();
  const std::vector<double> masses = lumped_masses(model);
  const CoarseLattice lattice = fit_lattice(model.rest_positions, free, target);
  struct Reach {
    std::uint32_t node;  // of the lattice
    std::uint32_t vertex;
    double weight;
  };
  std::vector<int> local(vertex_count, -1);
  std::uint32_t part_count = 0;
  const std::vector<std::uint32_t> free_part = pieces(free, edges, local, part_count);
  std::vector<std::uint32_t> part(vertex_count, 0);
  for (std::size_t i = 0; i < free.size(); ++i) part[free[i]] = free_part[i];
  const std::vector<CoarseLattice> lattices = part_lattices(lattice, model, edges, part, part_count);

  std::vector<Reach> reaches;
  for (const std::uint32_t v : free)
    for (const CoarseLattice::Corner& c : lattices[part[v]].corners(model.rest_positions[v]))
      if (c.weight > kLeastWeight) reaches.push_back({c.node, v, c.weight});
  std::stable_sort(reaches.begin(), reaches.end(), [](const Reach& a, const Reach& b) { return a.node < b.node; });

  // One node per lattice node and piece; weak ones are removed afterwards.
  std::vector<std::uint32_t> node_of(reaches.size()), node_part;
  std::vector<double> node_mass;
  for (std::size_t first = 0; first < reaches.size();) {
    std::size_t last = first;
    std::vector<std::uint32_t> members;
    while (last < reaches.size() && reaches[last].node == reaches[first].node)
      members.push_back(reaches[last++].vertex);
    std::uint32_t count = 0;
    const std::vector<std::uint32_t> piece = pieces(members, edges, local, count);
    const auto base = static_cast<std::uint32_t>(node_mass.size());
    node_mass.resize(base + count, 0.0);
    node_part.resize(base + count, 0);
    for (std::size_t i = 0; i < members.size(); ++i) {
      const std::uint32_t node = node_of[first + i] = base + piece[i];
      node_mass[node] += reaches[first + i].weight * masses[members[i]];
      node_part[node] = part[members[i]];
    }
    first = last;
  }
  std::vector<double> part_mass(part_count, 0);
  std::vector<std::uint32_t> part_nodes(part_count, 0);
  for (std::size_t j = 0; j < node_mass.size(); ++j) {
    part_mass[node_part[j]] += node_mass[j];
    ++part_nodes[node_part[j]];
  }
  const auto strong = [&](std::size_t j) {
    return node_mass[j] > kWeakNode * part_mass[node_part[j]] / part_nodes[node_part[j]];
  };
  // The heaviest parts get their nodes first, up to the limit.
  std::vector<std::uint32_t> strong_nodes(part_count, 0), by_mass(part_count);
  for (std::size_t j = 0; j < node_mass.size(); ++j) strong_nodes[node_part[j]] += strong(j);
  std::iota(by_mass.begin(), by_mass.end(), 0u);
  std::stable_sort(by_mass.begin(), by_mass.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return part_mass[a] > part_mass[b]; });
  std::vector<char> part_kept(part_count, 0);
  std::uint32_t room = most;
  complete = true;
  for (const std::uint32_t p : by_mass) {
    part_kept[p] = strong_nodes[p] <= room;
    if (part_kept[p]) room -= strong_nodes[p];
    complete = complete && part_kept[p];
  }
  CoarseSpace space;
  std::vector<int> kept(node_mass.size(), -1);
  for (std::size_t j = 0; j < node_mass.size(); ++j)
    if (strong(j) && part_kept[node_part[j]]) kept[j] = static_cast<int>(space.node_count++);

  std::vector<double> total(vertex_count, 0);
  for (std::size_t r = 0; r < reaches.size(); ++r)
    if (kept[node_of[r]] >= 0) total[reaches[r].vertex] += reaches[r].weight;
  space.begin.assign(vertex_count + 1, 0);
  const auto counts = [&](std::size_t r) { return kept[node_of[r]] >= 0 && total[reaches[r].vertex] > 1e-3; };
  for (std::size_t r = 0; r < reaches.size(); ++r)
    if (counts(r)) ++space.begin[reaches[r].vertex + 1];
  std::partial_sum(space.begin.begin(), space.begin.end(), space.begin.begin());
  space.node.resize(space.begin.back());
  space.weight.resize(space.begin.back());
  std::vector<std::uint32_t> next(space.begin.begin(), space.begin.end() - 1);
  for (std::size_t r = 0; r < reaches.size(); ++r) {
    if (!counts(r)) continue;
    const std::uint32_t v = reaches[r].vertex, at = next[v]++;
    space.node[at] = static_cast<std::uint32_t>(kept[node_of[r]]);
    space.weight[at] = reaches[r].weight / total[v];
  }
  order_nodes(space);
  return space;
}

}  // namespace

std::uint32_t coarse_node_target(std::size_t tet_count) {
  return static_cast<std::uint32_t>(std::clamp(2 * std::sqrt(static_cast<double>(tet_count)), 30.0, 500.0));
}

CoarseSpace make_coarse_space(const Model& model, std::uint32_t target) {
  CoarseSpace space;
  space.begin.assign(model.rest_positions.size() + 1, 0);
  const std::vector<char> held = model.held();
  const std::vector<double> masses = lumped_masses(model);
  std::vector<std::uint32_t> free;
  for (std::uint32_t v = 0; v < held.size(); ++v)
    if (!held[v] && masses[v] > 0) free.push_back(v);
  if (free.size() < kFewVertices) return space;
  target = std::min(target, static_cast<std::uint32_t>(free.size() / 3));

  // Many pieces result in many functions: the remedy is a coarser lattice, or functions shared between materials.
  const std::uint32_t most = target + target / 2;
  for (const bool cut_materials : {true, false}) {
    if (cut_materials && model.materials.size() == 1) continue;
    const Edges edges = free_edges(model, held, cut_materials);
    for (const double share : {1.0, 0.5, 0.25}) {
      bool complete = false;
      const auto wanted = std::max(8u, static_cast<std::uint32_t>(share * target));
      space = lattice_space(model, free, edges, wanted, most, complete);
      if (!complete) continue;
      if (space.node_count > kEnough * wanted) return space;
      // Weak nodes were removed: a finer lattice compensates for them, with at most twice as many nodes.
      const std::uint32_t more = space.node_count > wanted / 2 ? wanted * wanted / space.node_count : 2 * wanted;
      const CoarseSpace finer = lattice_space(model, free, edges, more, wanted + wanted / 4, complete);
      return complete ? finer : space;
    }
  }
  return space;
}

}  // namespace fascia
