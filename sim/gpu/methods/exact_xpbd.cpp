#include "sim/gpu/methods/exact_xpbd.h"

namespace fascia {

ExactXpbdMethod::ExactXpbdMethod(const SimBuffers& buffers)
    : multiplier_("multiplier", 2 * sizeof(shared::vec4) * buffers.tet_count),
      primal_step_("primal_step", sizeof(shared::vec4) * buffers.vertex_count),
      raised_mass_("raised_mass", sizeof(float) * buffers.vertex_count) {}

Passes ExactXpbdMethod::begin(const Recording& r) const {
  gl::ComputePass::Bindings bindings{{"step", &r.buffers.step},
                                     {"tet_vertices", &r.buffers.tet_vertices},
                                     {"tet_shape", &r.buffers.tet_shape},
                                     {"displacement", &r.buffers.displacement},
                                     {"multiplier", &multiplier_}};
  bindings = with_damping(with_material(std::move(bindings), r.features, r.buffers), r.features, r.previous_strain);
  Passes passes;
  passes
      .emplace_back(r.programs.compute("sim/xpbd/multiplier_start.comp", defines_of(r.features)), std::move(bindings),
                    r.buffers.tet_count)
      .loops(r.loops_of_tet());
  return passes;
}

Passes ExactXpbdMethod::iteration(const Recording& r, bool) const {
  gl::ComputePass::Bindings force{
      {"step", &r.buffers.step}, {"displacement", &r.buffers.displacement}, {"multiplier", &multiplier_}};
  force = with_material(with_slots(std::move(force), r.buffers), r.features, r.buffers);
  Passes passes = r.over_pairs_deferring("sim/xpbd/exact_tet.comp", defines_of(r.features), force);
  gl::ComputePass::Bindings vertex{{"step", &r.buffers.step},
                                   {"predicted", &r.buffers.predicted},
                                   {"mass", &r.buffers.mass},
                                   {"slot_begin", &r.buffers.slot_begin},
                                   {"copy_begin", &r.buffers.tet_begin},
                                   {"iterate", &r.buffers.displacement},
                                   {"correction", &r.buffers.correction},
                                   {"displacement", &r.buffers.displacement},
                                   {"primal_step", &primal_step_},
                                   {"raised_mass", &raised_mass_}};
  const gl::Defines vertex_defines = with_energy_terms({}, vertex, r.terms, TermUse::all);
  passes
      .emplace_back(r.programs.compute("sim/xpbd/exact_vertex.comp", vertex_defines), std::move(vertex),
                    r.buffers.vertex_count)
      .loops(r.loops_of_slots());

  gl::Defines defines = defines_of(r.features);
  defines.emplace_back("FIRST_ITERATION", "0");
  defines.emplace_back("EXACT", "1");
  gl::ComputePass::Bindings tet{{"step", &r.buffers.step},
                                {"displacement", &r.buffers.displacement},
                                {"primal_step", &primal_step_},
                                {"lambda", &multiplier_},
                                {"multiplier", &multiplier_}};
  tet = with_damping(with_material(with_slots(std::move(tet), r.buffers), r.features, r.buffers), r.features,
                     r.previous_strain);
  append(passes, r.over_pairs_deferring("sim/xpbd/jacobi_tet.comp", defines, tet));
  passes
      .emplace_back(r.programs.compute("sim/xpbd/jacobi_vertex.comp", {{"EXACT", "1"}}),
                    gl::ComputePass::Bindings{{"slot_begin", &r.buffers.slot_begin},
                                              {"copy_begin", &r.buffers.tet_begin},
                                              {"correction", &r.buffers.correction},
                                              {"primal_step", &primal_step_},
                                              {"iterate", &r.buffers.displacement},
                                              {"displacement", &r.buffers.displacement}},
                    r.buffers.vertex_count)
      .loops(r.loops_of_slots());
  return passes;
}

}  // namespace fascia
