#include "sim/gpu/jacobi.h"

namespace fascia {

JacobiMethod::JacobiMethod(std::uint32_t tet_count) : multiplier_("multiplier", 2 * sizeof(shared::vec4) * tet_count) {}

std::vector<gl::ComputePass> JacobiMethod::iteration(gl::ProgramCache& programs, const SimBuffers& buffers,
                                                     const Features& features, const gl::Buffer& previous_strain,
                                                     bool first) const {
  gl::Defines defines = defines_of(features);
  defines.emplace_back("FIRST_ITERATION", first ? "1" : "0");
  gl::ComputePass::Bindings tet{{"step", &buffers.step},
                                {"tet_vertices", &buffers.tet_vertices},
                                {"tet_shape", &buffers.tet_shape},
                                {"tet_slots", &buffers.tet_slots},
                                {"displacement", &buffers.displacement},
                                {"multiplier", &multiplier_},
                                {"correction", &buffers.correction}};
  tet = with_damping(with_material(std::move(tet), features, buffers), features, previous_strain);
  std::vector<gl::ComputePass> passes;
  passes.emplace_back(programs.compute("sim/jacobi_tet.comp", defines), std::move(tet), buffers.tet_count);
  passes.emplace_back(programs.compute("sim/jacobi_vertex.comp"),
                      gl::ComputePass::Bindings{{"slot_begin", &buffers.slot_begin},
                                                {"correction", &buffers.correction},
                                                {"displacement", &buffers.displacement}},
                      buffers.vertex_count);
  return passes;
}

}  // namespace fascia
