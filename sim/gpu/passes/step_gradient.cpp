#include "sim/gpu/passes/step_gradient.h"

namespace fascia {

StepGradient::StepGradient(const gl::ProgramCache& programs, const SimBuffers& buffers)
    : gradient_("gradient", buffers.vertex_count * sizeof(shared::vec4)) {
  if (ForceClusters::serve(programs, buffers)) clusters_.emplace(buffers);
}

// Deferred pairs are processed by a list in no order of clusters.
gl::ComputePass StepGradient::clustered(const Recording& r, gl::Defines defines,
                                        gl::ComputePass::Bindings bindings) const {
  defines.emplace_back("CLUSTERS", "1");
  bindings = with_pairs(std::move(bindings), r.buffers);
  bindings.insert(bindings.end(), {{"clusters", &clusters_->lists()}, {"correction", &clusters_->forces()}});
  if (r.active) {
    defines.emplace_back("LISTED", "1");
    bindings.emplace_back("item_list", &r.active->clusters);
  }
  gl::ComputePass::Constants constants = constants_of_pairs(r.buffers);
  constants.emplace_back("pair_and_single_count", r.buffers.pair_and_single_count());
  gl::ComputePass pass(r.programs.compute("sim/elasticity/elastic_force.comp", defines), std::move(bindings),
                       ForceClusters::kPairs * clusters_->count(), std::move(constants));
  count_bytes_of_pairs(pass, r.buffers);
  if (r.active) pass.follow("invocations", r.active->cluster_invocations);
  return pass;
}

Passes StepGradient::passes(const Recording& r, const std::optional<PendingStep>& pending, bool evaluated,
                            const VertexBlocks* blocks) const {
  gl::ComputePass::Bindings tet{{"step", &r.buffers.step}, {"displacement", &r.buffers.displacement}};
  tet = with_damping(with_material(std::move(tet), r.features, r.buffers), r.features, r.previous_strain);
  gl::Defines tet_defines = defines_of(r.features);
  tet_defines.emplace_back("COMPENSATED", r.buffers.displacement_low ? "1" : "0");
  if (r.buffers.displacement_low) tet.emplace_back("displacement_low", &r.buffers.displacement_low);
  gl::ComputePass::Bindings vertex{{"step", &r.buffers.step},
                                   {pending ? "iterate" : "displacement", &r.buffers.displacement},
                                   {"predicted", &r.buffers.predicted},
                                   {"mass", &r.buffers.own_masses()},
                                   {"gradient", &gradient_}};
  const bool clusters = clusters_ && !r.deferred;
  vertex.emplace_back("slot_begin", clusters ? &clusters_->slot_begin() : &r.buffers.slot_begin);
  vertex.emplace_back("correction", clusters ? &clusters_->forces() : &r.buffers.correction);
  gl::Defines vertex_defines = with_energy_terms({}, vertex, r.terms, TermUse::gradient);
  for (gl::Defines* defines : {&tet_defines, &vertex_defines}) {
    defines->emplace_back("MOVES", pending ? "1" : "0");
    if (pending) defines->insert(defines->end(), pending->defines.begin(), pending->defines.end());
  }
  if (r.has_blocks()) vertex.emplace_back("start_displacement", &r.buffers.start_of_stage());
  vertex_defines.emplace_back("FROM_START", r.has_blocks() ? "1" : "0");
  if (pending) {
    for (gl::ComputePass::Bindings* bindings : {&tet, &vertex})
      bindings->insert(bindings->end(), pending->step.begin(), pending->step.end());
    vertex.emplace_back("previous_gradient", &pending->previous_gradient);
  }
  Passes passes;
  if (!evaluated) passes = r.evaluations(blocks);
  if (clusters)
    passes.push_back(clustered(r, tet_defines, tet));
  else if (r.buffers.has_linear())
    append(passes,
           r.over_pairs_deferring("sim/elasticity/elastic_force.comp", tet_defines, with_slots(tet, r.buffers)));
  if (r.buffers.has_quadratic()) {
    tet.emplace_back("predicted_centroid", &r.buffers.predicted_centroid);
    tet.emplace_back("multiplier", &r.buffers.multiplier);
    tet_defines.emplace_back("RELAXED", "1");
    if (r.has_blocks()) tet.emplace_back("start_displacement", &r.buffers.start_of_stage());
    tet_defines.emplace_back("FROM_START", r.has_blocks() ? "1" : "0");
    append(passes, r.over_quadratic_deferring("sim/quadratic/quadratic_force.comp", tet_defines,
                                              with_quadratic_slots(tet, r.buffers)));
  }
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
