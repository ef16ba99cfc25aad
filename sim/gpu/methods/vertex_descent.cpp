#include "sim/gpu/methods/vertex_descent.h"

#include <algorithm>

#include "sim/gpu/passes/step_gradient.h"

namespace fascia {

namespace {

// Neighboring invocations take as long as the one with the most tets: within some hundred neighbors of a color,
// vertices with equal numbers of tets are adjacent.
VertexColoring alike_together(VertexColoring coloring, const std::vector<std::uint32_t>& tet_begin) {
  constexpr std::uint32_t kNeighbors = 256;
  const auto tets = [&](std::uint32_t v) { return tet_begin[v + 1] - tet_begin[v]; };
  for (std::size_t color = 0; color + 1 < coloring.begin.size(); ++color)
    for (std::uint32_t begin = coloring.begin[color]; begin < coloring.begin[color + 1]; begin += kNeighbors)
      std::stable_sort(coloring.order.begin() + begin,
                       coloring.order.begin() + std::min(begin + kNeighbors, coloring.begin[color + 1]),
                       [&](std::uint32_t a, std::uint32_t b) { return tets(a) > tets(b); });
  return coloring;
}

}  // namespace

VertexDescentMethod::VertexDescentMethod(const Model& model, const SimBuffers& buffers)
    : coloring_(alike_together(color_vertices(model.tets, model.held()), buffers.tet_offsets)),
      vertex_tets_(make_vertex_tets(buffers)),
      color_vertex_("color_vertex", coloring_.order) {}

Passes VertexDescentMethod::iteration(const Recording& r, bool) const {
  gl::ComputePass::Bindings bindings{{"step", &r.buffers.step},
                                     {"tet_vertices", &r.buffers.tet_vertices},
                                     {"tet_shape", &r.buffers.tet_shape},
                                     {"neighbor", &r.buffers.displacement},
                                     {"displacement", &r.buffers.displacement},
                                     {"predicted", &r.buffers.predicted},
                                     {"mass", &r.buffers.mass},
                                     {"tet_begin", &r.buffers.tet_begin},
                                     {"vertex_tets", &vertex_tets_},
                                     {"color_vertex", &color_vertex_}};
  bindings = with_damping(with_material(std::move(bindings), r.features, r.buffers), r.features, r.previous_strain);
  const gl::Defines defines = with_energy_terms(defines_of(r.features), bindings, r.terms, TermUse::all);
  return r.over_ranges_deferring("sim/vertex_descent/vertex_descent.comp", defines, bindings, coloring_.begin,
                                 r.loops_of_vertex(), r.buffers.most_tets);
}

}  // namespace fascia
