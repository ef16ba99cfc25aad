#include "sim/gpu/gauss_seidel.h"

namespace fascia {

GaussSeidelMethod::GaussSeidelMethod(const Model& model)
    : multiplier_("multiplier", 2 * sizeof(shared::vec4) * model.tets.size()) {
  const Coloring coloring = color_tets(model.tets, model.held());
  color_begin_ = coloring.begin;
  color_tet_ = gl::Buffer("color_tet", coloring.order);
}

std::vector<gl::ComputePass> GaussSeidelMethod::iteration(gl::ProgramCache& programs, const SimBuffers& buffers,
                                                          const Features& features, const gl::Buffer& previous_strain,
                                                          bool first) const {
  gl::Defines defines = defines_of(features);
  defines.emplace_back("FIRST_ITERATION", first ? "1" : "0");
  const gl::Program& program = programs.compute("sim/gauss_seidel.comp", defines);
  gl::ComputePass::Bindings bindings{{"step", &buffers.step},           {"tet_vertices", &buffers.tet_vertices},
                                     {"tet_shape", &buffers.tet_shape}, {"color_tet", &color_tet_},
                                     {"multiplier", &multiplier_},      {"displacement", &buffers.displacement}};
  bindings = with_damping(with_material(std::move(bindings), features, buffers), features, previous_strain);
  std::vector<gl::ComputePass> passes;
  for (std::size_t color = 0; color + 1 < color_begin_.size(); ++color)
    passes.emplace_back(program, bindings, color_begin_[color + 1] - color_begin_[color], color_begin_[color]);
  return passes;
}

}  // namespace fascia
