#include "sim/gpu/methods/jacobi.h"

namespace fascia {

JacobiMethod::JacobiMethod(const SimBuffers& buffers, bool split_masses)
    : copy_begin_(split_masses ? &buffers.tet_begin : nullptr),
      multiplier_("multiplier", 2 * sizeof(shared::vec4) * buffers.tet_count) {}

Passes JacobiMethod::iteration(const Recording& r, bool first) const {
  gl::Defines defines = defines_of(r.features);
  defines.emplace_back("FIRST_ITERATION", first ? "1" : "0");
  defines.emplace_back("EXACT", "0");
  gl::ComputePass::Bindings tet{{"step", &r.buffers.step},
                                {"displacement", &r.buffers.displacement},
                                {"lambda", &multiplier_},
                                {"multiplier", &multiplier_}};
  tet = with_damping(with_material(with_slots(std::move(tet), r.buffers), r.features, r.buffers), r.features,
                     r.previous_strain);
  Passes passes = r.over_pairs_deferring("sim/xpbd/jacobi_tet.comp", defines, tet);
  passes
      .emplace_back(r.programs.compute("sim/xpbd/jacobi_vertex.comp", {{"EXACT", "0"}}),
                    gl::ComputePass::Bindings{{"slot_begin", &r.buffers.slot_begin},
                                              {"copy_begin", &r.buffers.tet_begin},
                                              {"correction", &r.buffers.correction},
                                              {"iterate", &r.buffers.displacement},
                                              {"displacement", &r.buffers.displacement}},
                    r.buffers.vertex_count)
      .loops(r.loops_of_slots());
  append(passes, r.projections(first));
  return passes;
}

}  // namespace fascia
