#include "sim/ordering/graph_coloring.h"

#include <algorithm>
#include <numeric>

namespace fascia {
namespace {

// The colors of the tets around each vertex: one bit per color.
class UsedColors {
 public:
  explicit UsedColors(std::size_t vertex_count) : words_(vertex_count * words_per_vertex_) {}

  bool has(std::uint32_t vertex, std::uint32_t color) const {
    return color / 64 < words_per_vertex_ && (words_[vertex * words_per_vertex_ + color / 64] >> (color % 64) & 1);
  }
  void set(std::uint32_t vertex, std::uint32_t color, bool used) {
    while (color / 64 >= words_per_vertex_) widen();
    std::uint64_t& word = words_[vertex * words_per_vertex_ + color / 64];
    const std::uint64_t bit = std::uint64_t{1} << (color % 64);
    word = used ? word | bit : word & ~bit;
  }

 private:
  void widen() {
    const std::size_t wider = words_per_vertex_ * 2, vertices = words_.size() / words_per_vertex_;
    std::vector<std::uint64_t> words(vertices * wider);
    for (std::size_t v = 0; v < vertices; ++v)
      std::copy_n(words_.begin() + v * words_per_vertex_, words_per_vertex_, words.begin() + v * wider);
    words_ = std::move(words);
    words_per_vertex_ = wider;
  }

  std::size_t words_per_vertex_ = 1;
  std::vector<std::uint64_t> words_;
};

// Sorts tets by color and finishes the coloring.
void sort_by_color(Coloring& coloring, const std::vector<std::uint32_t>& visit,
                   const std::vector<std::uint32_t>& color_of, const std::vector<std::uint32_t>& size) {
  coloring.begin.assign(size.size() + 1, 0);
  std::partial_sum(size.begin(), size.end(), coloring.begin.begin() + 1);
  std::vector<std::uint32_t> next(coloring.begin.begin(), coloring.begin.end() - 1);
  coloring.order.resize(visit.size());
  for (const std::uint32_t t : visit) coloring.order[next[color_of[t]]++] = t;
}

Coloring color_exactly(const std::vector<Tet>& tets, const std::vector<char>& held,
                       const std::vector<std::uint32_t>& visit) {
  UsedColors used(held.size());
  std::vector<std::uint32_t> color_of(tets.size()), size;
  const auto allowed = [&](const Tet& tet, std::uint32_t color) {
    return std::none_of(tet.begin(), tet.end(), [&](std::uint32_t v) { return !held[v] && used.has(v, color); });
  };
  const auto mark = [&](const Tet& tet, std::uint32_t color, bool on) {
    for (const std::uint32_t v : tet)
      if (!held[v]) used.set(v, color, on);
  };
  for (const std::uint32_t t : visit) {
    std::uint32_t color = 0;
    while (color < size.size() && !allowed(tets[t], color)) ++color;
    if (color == size.size()) size.push_back(0);
    mark(tets[t], color, true);
    color_of[t] = color;
    ++size[color];
  }
  // First fit fills the first colors and leaves few tets in the last ones.
  const std::size_t mean = tets.size() / std::max<std::size_t>(1, size.size());
  for (const std::uint32_t t : visit) {
    const std::uint32_t from = color_of[t];
    if (size[from] <= mean) continue;
    std::uint32_t to = from;
    for (std::uint32_t color = 0; color < size.size(); ++color)
      if (size[color] < size[to] && allowed(tets[t], color)) to = color;
    if (to == from || size[to] + 1 >= size[from]) continue;
    mark(tets[t], from, false);
    mark(tets[t], to, true);
    --size[from];
    ++size[to];
    color_of[t] = to;
  }
  Coloring coloring;
  coloring.corners = tets;
  sort_by_color(coloring, visit, color_of, size);
  return coloring;
}

// The copies of every vertex, each with the colors that move it: a bit per color.
class Copies {
 public:
  explicit Copies(std::size_t vertex_count) : masks_(vertex_count, std::vector<std::uint64_t>(1)) {}

  /// The first copy that `color` does not move yet; count(vertex) if there is none.
  std::size_t free_copy(std::uint32_t vertex, std::uint32_t color) const {
    std::size_t copy = 0;
    while (copy < masks_[vertex].size() && (masks_[vertex][copy] >> color & 1)) ++copy;
    return copy;
  }
  std::size_t count(std::uint32_t vertex) const { return masks_[vertex].size(); }
  void take(std::uint32_t vertex, std::size_t copy, std::uint32_t color) {
    if (copy == masks_[vertex].size()) masks_[vertex].push_back(0);
    masks_[vertex][copy] |= std::uint64_t{1} << color;
  }

 private:
  std::vector<std::vector<std::uint64_t>> masks_;
};

Coloring color_with_phantoms(const std::vector<Tet>& tets, const std::vector<char>& held,
                             const std::vector<std::uint32_t>& visit, std::uint32_t color_count) {
  Copies copies(held.size());
  std::vector<std::uint32_t> color_of(tets.size()), size(color_count);
  std::vector<Tet> copy_of(tets.size());
  for (const std::uint32_t t : visit) {
    std::uint32_t best = 0, fewest = 5;
    for (std::uint32_t color = 0; color < color_count; ++color) {
      std::uint32_t phantoms = 0;
      for (const std::uint32_t v : tets[t])
        if (!held[v] && copies.free_copy(v, color) == copies.count(v)) ++phantoms;
      if (phantoms > fewest || (phantoms == fewest && size[color] >= size[best])) continue;
      best = color;
      fewest = phantoms;
    }
    color_of[t] = best;
    ++size[best];
    for (int a = 0; a < 4; ++a) {
      const std::uint32_t v = tets[t][a];
      copy_of[t][a] = held[v] ? 0 : static_cast<std::uint32_t>(copies.free_copy(v, best));
      if (!held[v]) copies.take(v, copy_of[t][a], best);
    }
  }
  Coloring coloring;
  const auto vertex_count = static_cast<std::uint32_t>(held.size());
  std::vector<std::uint32_t> first(vertex_count);  // phantom of each vertex
  for (std::uint32_t v = 0; v < vertex_count; ++v) {
    first[v] = vertex_count + static_cast<std::uint32_t>(coloring.phantom_vertex.size());
    coloring.phantom_vertex.insert(coloring.phantom_vertex.end(), copies.count(v) - 1, v);
  }
  coloring.corners = tets;
  for (std::size_t t = 0; t < tets.size(); ++t)
    for (int a = 0; a < 4; ++a)
      if (copy_of[t][a] > 0) coloring.corners[t][a] = first[tets[t][a]] + copy_of[t][a] - 1;
  std::erase(size, 0u);  // if there are fewer tets than colors
  sort_by_color(coloring, visit, color_of, size);
  return coloring;
}

}  // namespace

Coloring color_tets(const std::vector<Tet>& tets, const std::vector<char>& held,
                    const std::vector<std::uint32_t>& visit, std::uint32_t max_colors) {
  return max_colors == 0 ? color_exactly(tets, held, visit)
                         : color_with_phantoms(tets, held, visit, std::min<std::uint32_t>(max_colors, 64));
}

VertexColoring color_vertices(const std::vector<Tet>& tets, const std::vector<char>& held) {
  const std::size_t vertex_count = held.size();
  std::vector<std::uint32_t> tet_begin(vertex_count + 1, 0);
  for (const Tet& tet : tets)
    for (const std::uint32_t v : tet) ++tet_begin[v + 1];
  std::partial_sum(tet_begin.begin(), tet_begin.end(), tet_begin.begin());
  std::vector<std::uint32_t> around(tet_begin.back()), next(tet_begin.begin(), tet_begin.end() - 1);
  for (std::uint32_t t = 0; t < tets.size(); ++t)
    for (const std::uint32_t v : tets[t]) around[next[v]++] = t;

  constexpr std::uint32_t kNone = ~0u;
  std::vector<std::uint32_t> color(vertex_count, kNone), taken;  // taken: the last vertex that used each color
  VertexColoring coloring{{}, {0}};
  for (std::uint32_t v = 0; v < vertex_count; ++v) {
    if (held[v] || tet_begin[v] == tet_begin[v + 1]) continue;
    for (std::uint32_t k = tet_begin[v]; k < tet_begin[v + 1]; ++k)
      for (const std::uint32_t other : tets[around[k]])
        if (color[other] != kNone) taken[color[other]] = v;
    std::uint32_t c = 0;
    while (c < taken.size() && taken[c] == v) ++c;
    if (c == taken.size()) {
      taken.push_back(kNone);
      coloring.begin.push_back(0);
    }
    color[v] = c;
    ++coloring.begin[c + 1];
  }
  std::partial_sum(coloring.begin.begin(), coloring.begin.end(), coloring.begin.begin());
  coloring.order.resize(coloring.begin.back());
  std::vector<std::uint32_t> at(coloring.begin.begin(), coloring.begin.end() - 1);
  for (std::uint32_t v = 0; v < vertex_count; ++v)
    if (color[v] != kNone) coloring.order[at[color[v]]++] = v;
  return coloring;
}

}  // namespace fascia
