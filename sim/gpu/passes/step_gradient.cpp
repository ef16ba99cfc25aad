#include "sim/gpu/passes/step_gradient.h"

namespace fascia {

StepGradient::StepGradient(const SimBuffers& buffers)
    : gradient_("gradient", buffers.vertex_count * sizeof(shared::vec4)) {}

Passes StepGradient::passes(const Recording& r, const std::optional<PendingStep>& pending) const {
  gl::ComputePass::Bindings tet{{"step", &r.buffers.step}, {"displacement", &r.buffers.displacement}};
  tet = with_damping(with_material(std::move(tet), r.features, r.buffers), r.features, r.previous_strain);
  gl::Defines tet_defines = defines_of(r.features);
  tet_defines.emplace_back("COMPENSATED", r.buffers.displacement_low ? "1" : "0");
  if (r.buffers.displacement_low) tet.emplace_back("displacement_low", &r.buffers.displacement_low);
  gl::ComputePass::Bindings vertex{{"step", &r.buffers.step},
                                   {pending ? "iterate" : "displacement", &r.buffers.displacement},
                                   {"predicted", &r.buffers.predicted},
                                   {"mass", &r.buffers.mass},
                                   {"slot_begin", &r.buffers.slot_begin},
                                   {"correction", &r.buffers.correction},
                                   {"gradient", &gradient_}};
  gl::Defines vertex_defines = with_energy_terms({}, vertex, r.terms, TermUse::gradient);
  for (gl::Defines* defines : {&tet_defines, &vertex_defines}) {
    defines->emplace_back("MOVES", pending ? "1" : "0");
    if (pending) defines->insert(defines->end(), pending->defines.begin(), pending->defines.end());
  }
  if (pending) {
    for (gl::ComputePass::Bindings* bindings : {&tet, &vertex})
      bindings->insert(bindings->end(), pending->step.begin(), pending->step.end());
    vertex.emplace_back("previous_gradient", &pending->previous_gradient);
  }
  Passes passes = r.evaluations();
  if (r.buffers.has_linear())
    append(passes,
           r.over_pairs_deferring("sim/elasticity/elastic_force.comp", tet_defines, with_slots(tet, r.buffers)));
  if (r.buffers.has_quadratic())
    append(passes, r.over_quadratic_deferring("sim/quadratic/quadratic_force.comp", tet_defines,
                                              with_quadratic_slots(tet, r.buffers)));
  passes.push_back(r.over_vertices("sim/elasticity/gradient.comp", vertex_defines, std::move(vertex)));
  passes.back().loops(r.loops_of_slots());
  return passes;
}

gl::Buffer make_vertex_tets(const SimBuffers& buffers) {
  std::vector<std::uint32_t> next = buffers.tet_offsets;  // next free entry of each vertex
  std::vector<std::uint32_t> entries(next.back());
  for (std::uint32_t t = 0; t < buffers.linear_count(); ++t)
    for (std::uint32_t a = 0; a < 4; ++a) entries[next[buffers.tets[t][a]]++] = 4 * t + a;
  return {"vertex_tets", entries};
}

gl::Buffer make_vertex_quadratic(const SimBuffers& buffers) {
  std::vector<std::uint32_t> next = buffers.quadratic_offsets;
  std::vector<std::uint32_t> entries(next.back());
  for (std::uint32_t q = 0; q < buffers.quadratic_count; ++q) {
    for (std::uint32_t a = 0; a < 4; ++a) entries[next[buffers.tets[buffers.linear_count() + q][a]]++] = 10 * q + a;
    for (std::uint32_t a = 4; a < 10; ++a) entries[next[buffers.mid_edge_vertices[q][a - 4]]++] = 10 * q + a;
  }
  return {"vertex_quadratic", entries};
}

}  // namespace fascia
