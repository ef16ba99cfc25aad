#include "sim/gpu/passes/step_gradient.h"

namespace fascia {

StepGradient::StepGradient(const SimBuffers& buffers)
    : gradient_("gradient", buffers.vertex_count * sizeof(shared::vec4)) {}

Passes StepGradient::passes(const Recording& r) const {
  gl::ComputePass::Bindings tet{{"step", &r.buffers.step}, {"displacement", &r.buffers.displacement}};
  tet = with_damping(with_material(with_slots(std::move(tet), r.buffers), r.features, r.buffers), r.features,
                     r.previous_strain);
  gl::Defines tet_defines = defines_of(r.features);
  tet_defines.emplace_back("COMPENSATED", r.buffers.displacement_low ? "1" : "0");
  if (r.buffers.displacement_low) tet.emplace_back("displacement_low", &r.buffers.displacement_low);
  gl::ComputePass::Bindings vertex{
      {"step", &r.buffers.step}, {"displacement", &r.buffers.displacement}, {"predicted", &r.buffers.predicted},
      {"mass", &r.buffers.mass}, {"slot_begin", &r.buffers.slot_begin},     {"correction", &r.buffers.correction},
      {"gradient", &gradient_}};
  const gl::Defines vertex_defines = with_energy_terms({}, vertex, r.terms, TermUse::gradient);
  Passes passes = r.evaluations();
  if (r.features.quadratic)
    passes.push_back(r.over_pairs("sim/quadratic/quadratic_force.comp", tet_defines, tet));
  else
    append(passes, r.over_pairs_deferring("sim/elasticity/elastic_force.comp", tet_defines, tet));
  passes.push_back(r.over_vertices("sim/elasticity/gradient.comp", vertex_defines, std::move(vertex)));
  passes.back().loops(r.loops_of_slots());
  return passes;
}

gl::Buffer make_vertex_tets(const SimBuffers& buffers) {
  const std::vector<Tet>& tets = buffers.tets;
  std::vector<std::uint32_t> next = buffers.tet_offsets;  // next free entry of each vertex
  const std::uint32_t nodes = buffers.quadratic() ? 10 : 4;
  std::vector<std::uint32_t> entries(nodes * tets.size());
  for (std::uint32_t t = 0; t < tets.size(); ++t) {
    for (std::uint32_t a = 0; a < 4; ++a) entries[next[tets[t][a]]++] = nodes * t + a;
    for (std::uint32_t a = 4; a < nodes; ++a) entries[next[buffers.mid_edge_vertices[t][a - 4]]++] = nodes * t + a;
  }
  return {"vertex_tets", entries};
}

}  // namespace fascia
