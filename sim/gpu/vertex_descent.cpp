#include "sim/gpu/vertex_descent.h"

#include "sim/gpu/step_gradient.h"

namespace fascia {

VertexDescentMethod::VertexDescentMethod(const Model& model, const SimBuffers& buffers)
    : coloring_(color_vertices(model.tets, model.held())),
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
  const gl::Defines defines = r.grab.with_springs(defines_of(r.features), bindings);
  return r.over_ranges_deferring("sim/vertex_descent.comp", defines, bindings, coloring_.begin, r.loops_of_vertex(), r.buffers.most_tets);
}

}  // namespace fascia
