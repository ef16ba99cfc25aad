#include "sim/coloring.h"

#include <algorithm>
#include <numeric>

namespace fascia {
namespace {

// The colors that the tets around each vertex have: one bit per color.
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

}  // namespace

Coloring color_tets(const std::vector<Tet>& tets, const std::vector<char>& held) {
  UsedColors used(held.size());
  std::vector<std::uint32_t> color_of(tets.size()), size;
  const auto allowed = [&](const Tet& tet, std::uint32_t color) {
    return std::none_of(tet.begin(), tet.end(), [&](std::uint32_t v) { return !held[v] && used.has(v, color); });
  };
  const auto mark = [&](const Tet& tet, std::uint32_t color, bool on) {
    for (const std::uint32_t v : tet)
      if (!held[v]) used.set(v, color, on);
  };
  for (std::size_t t = 0; t < tets.size(); ++t) {
    std::uint32_t color = 0;
    while (color < size.size() && !allowed(tets[t], color)) ++color;
    if (color == size.size()) size.push_back(0);
    mark(tets[t], color, true);
    color_of[t] = color;
    ++size[color];
  }
  // First fit fills the first colors and leaves crumbs in the last ones.
  const std::size_t mean = tets.size() / std::max<std::size_t>(1, size.size());
  for (std::size_t t = 0; t < tets.size(); ++t) {
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
  coloring.begin.assign(size.size() + 1, 0);
  std::partial_sum(size.begin(), size.end(), coloring.begin.begin() + 1);
  std::vector<std::uint32_t> next(coloring.begin.begin(), coloring.begin.end() - 1);
  coloring.order.resize(tets.size());
  for (std::uint32_t t = 0; t < tets.size(); ++t) coloring.order[next[color_of[t]]++] = t;
  return coloring;
}

}  // namespace fascia
