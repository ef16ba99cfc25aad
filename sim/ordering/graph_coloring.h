// Colors for tets: no two tets of one color move the same vertex, so that they can be solved in place and in parallel.
#pragma once
#include <cstdint>
#include <vector>

#include "sim/mesh/tet_mesh.h"

namespace fascia {

struct Coloring {
  std::vector<std::uint32_t> order;  // [tet_count] tets sorted by color, within a color in the order they were given in
  std::vector<std::uint32_t> begin;  // [color_count + 1] first entry of each color in `order`
  /// [tet_count], by tet: what each corner moves: its vertex v, or one of v's phantoms: vertex_count + index in
  /// phantom_vertex.
  std::vector<Tet> corners;
  std::vector<std::uint32_t> phantom_vertex;  // [phantom_count] the vertex each phantom represents, ascending

  std::size_t color_count() const { return begin.empty() ? 0 : begin.size() - 1; }
};

/// Greedy, in the order `visit` [tet_count] (see curve_order). Constrained vertices (`held` [vertex_count], 1 where
/// constrained) cause no conflicts. Same input, same coloring.
///
/// `max_colors` 0: first fit, then tets of large colors move to the smallest possible color, so that no dispatch is
/// tiny. Otherwise at most so many colors: a vertex that would need more is split into phantoms, and each color moves
/// at most one of its copies (Fratarcangeli and Pellacini 2015 bound the colors by phantom constraints in the same way;
/// here a tet takes the color that needs the fewest new phantoms, and of those the smallest).
Coloring color_tets(const std::vector<Tet>& tets, const std::vector<char>& held,
                    const std::vector<std::uint32_t>& visit, std::uint32_t max_colors = 0);

/// Colors for vertices: no two of one color share a tet. Constrained vertices and those in no tet have none.
struct VertexColoring {
  std::vector<std::uint32_t> order;  // colored vertices sorted by color, within a color by index
  std::vector<std::uint32_t> begin;  // [color_count + 1] first entry of each color in `order`
  std::size_t color_count() const { return begin.size() - 1; }
};
/// Greedy, first fit in the order of the vertices. Same input, same coloring.
VertexColoring color_vertices(const std::vector<Tet>& tets, const std::vector<char>& held);

}  // namespace fascia
