#include "sim/gpu/passes/recording.h"

#include <algorithm>

namespace fascia {
namespace {

void list(gl::Defines& defines, gl::ComputePass::Bindings& bindings, const gl::Buffer& items) {
  defines.emplace_back("LISTED", "1");
  bindings.emplace_back("item_list", &items);
}

// Constants of the kernel that fills a list and of the one that processes it: the list, and its first item.
gl::ComputePass::Constants list_constants(const Deferral& most, std::uint32_t list, std::uint32_t first_item) {
  return {{"deferred_list", 4 * list}, {"deferred_begin", 4 * most.lists + first_item}};
}

void append(gl::ComputePass::Constants& constants, gl::ComputePass::Constants more) {
  for (auto& constant : more) constants.push_back(std::move(constant));
}

}  // namespace

bool Recording::has_blocks() const {
  return std::any_of(terms.begin(), terms.end(),
                     [](const EnergyTerm* term) { return term->acts() && term->has_blocks(); });
}

bool Recording::evaluates_blocks() const {
  return std::any_of(terms.begin(), terms.end(),
                     [](const EnergyTerm* term) { return term->acts() && term->evaluates_blocks(); });
}

Passes Recording::beginnings() const {
  Passes passes;
  for (const EnergyTerm* term : terms)
    if (term->acts()) append(passes, term->begin(programs, buffers));
  return passes;
}

Passes Recording::advances(const gl::Buffer& step) const {
  Passes passes;
  for (const EnergyTerm* term : terms)
    if (term->acts()) append(passes, term->advance(*this, step));
  return passes;
}

Passes Recording::evaluations(const VertexBlocks* blocks) const {
  Passes passes;
  for (const EnergyTerm* term : terms)
    if (term->acts()) append(passes, term->evaluate(programs, buffers, blocks));
  return passes;
}

Passes Recording::endings(bool moves_bodies) const {
  Passes passes;
  for (const EnergyTerm* term : terms)
    if (term->acts()) append(passes, term->finish(programs, buffers, moves_bodies));
  return passes;
}

Passes Recording::projections(bool first) const {
  Passes passes;
  for (const EnergyTerm* term : terms)
    if (term->acts()) append(passes, term->project(programs, buffers, first));
  return passes;
}

gl::ComputePass Recording::over_vertices(const char* kernel, gl::Defines defines, gl::ComputePass::Bindings bindings,
                                         gl::ComputePass::Constants constants) const {
  if (active) list(defines, bindings, active->vertices);
  gl::ComputePass pass(programs.compute(kernel, defines), std::move(bindings), buffers.vertex_count,
                       std::move(constants));
  pass.loops(0);
  if (active) pass.follow("invocations", active->vertex_count);
  return pass;
}

gl::ComputePass Recording::over_tets(const char* kernel, gl::Defines defines,
                                     gl::ComputePass::Bindings bindings) const {
  gl::ComputePass pass(programs.compute(kernel, defines), std::move(bindings), buffers.tet_count);
  pass.loops(loops_of_tet());
  return pass;
}

gl::ComputePass Recording::over_pairs(const char* kernel, gl::Defines defines, gl::ComputePass::Bindings bindings,
                                      gl::ComputePass::Constants constants) const {
  if (active) list(defines, bindings, active->pairs);
  append(constants, constants_of_pairs(buffers));
  gl::ComputePass pass(programs.compute(kernel, defines), std::move(bindings), buffers.pair_and_single_count(),
                       std::move(constants));
  pass.loops(loops_of_pair());
  count_bytes_of_pairs(pass, buffers);
  if (active) pass.follow("invocations", active->pair_count);
  return pass;
}

gl::ComputePass Recording::over_quadratic(const char* kernel, gl::Defines defines, gl::ComputePass::Bindings bindings,
                                          gl::ComputePass::Constants constants) const {
  if (active) list(defines, bindings, active->quadratic);
  append(constants, constants_of_quadratic(buffers));
  gl::ComputePass pass(programs.compute(kernel, defines_of_quadratic(std::move(defines), buffers)), std::move(bindings),
                       buffers.quadratic_count, std::move(constants));
  pass.loops(loops_of_quadratic());
  if (active) pass.follow("invocations", active->quadratic_count);
  return pass;
}

Passes Recording::over_pairs_deferring(const char* kernel, const gl::Defines& defines,
                                       const gl::ComputePass::Bindings& bindings) const {
  if (!deferred) return {over_pairs(kernel, defines, bindings)};
  auto [first_defines, first_bindings] = deferring(defines, bindings);
  Passes passes{
      over_pairs(kernel, std::move(first_defines), std::move(first_bindings), list_constants(deferred->most, 0, 0))};
  passes.back().loops(0);
  passes.back().copy_first(deferred->none, deferred->lists);
  passes.push_back(over_deferred(kernel, defines, bindings));
  return passes;
}

gl::ComputePass Recording::over_deferred(const char* kernel, gl::Defines defines,
                                         gl::ComputePass::Bindings bindings) const {
  gl::ComputePass::Constants constants = list_constants(deferred->most, 0, 0);
  append(constants, constants_of_pairs(buffers));
  gl::ComputePass pass = over_deferred(kernel, std::move(defines), std::move(bindings), 0,
                                       buffers.pair_and_single_count(), std::move(constants));
  pass.loops(loops_of_pair());
  return pass;
}

Passes Recording::over_ranges_deferring(const char* kernel, const gl::Defines& defines,
                                        const gl::ComputePass::Bindings& bindings,
                                        const std::vector<std::uint32_t>& begin, std::uint32_t loops,
                                        std::uint32_t decompositions) const {
  const std::uint32_t loops_decomposing = loops + decompositions * loops_of_tet();
  Passes passes;
  for (std::uint32_t k = 0; k + 1 < begin.size(); ++k) {
    const std::uint32_t count = begin[k + 1] - begin[k];
    gl::ComputePass::Constants constants{{"first_item", begin[k]}};
    if (!deferred) {
      passes.emplace_back(programs.compute(kernel, defines), bindings, count, constants).loops(loops_decomposing);
      continue;
    }
    auto [first_defines, first_bindings] = deferring(defines, bindings);
    for (auto& constant : list_constants(deferred->most, k, begin[k])) constants.push_back(std::move(constant));
    passes.emplace_back(programs.compute(kernel, first_defines), std::move(first_bindings), count, constants)
        .loops(loops);
    if (k == 0) passes.back().copy_first(deferred->none, deferred->lists);
    passes.push_back(over_deferred(kernel, defines, bindings, k, count, std::move(constants)));
    passes.back().loops(loops_decomposing);
  }
  return passes;
}

// Deferred quadratic tets have the list after that of pairs.
gl::ComputePass::Constants Recording::list_of_quadratic() const {
  return list_constants(deferred->most, buffers.has_linear(), buffers.pair_and_single_count());
}

Passes Recording::over_quadratic_deferring(const char* kernel, const gl::Defines& defines,
                                           const gl::ComputePass::Bindings& bindings) const {
  if (!deferred) return {over_quadratic(kernel, defines, bindings)};
  auto [first_defines, first_bindings] = deferring(defines, bindings);
  Passes passes{over_quadratic(kernel, std::move(first_defines), std::move(first_bindings), list_of_quadratic())};
  passes.back().loops(kPoints);
  if (!buffers.has_linear()) passes.back().copy_first(deferred->none, deferred->lists);  // else pairs have done it
  passes.push_back(over_deferred_quadratic(kernel, defines, bindings));
  return passes;
}

gl::ComputePass Recording::over_deferred_quadratic(const char* kernel, gl::Defines defines,
                                                   gl::ComputePass::Bindings bindings) const {
  gl::ComputePass::Constants constants = list_of_quadratic();
  append(constants, constants_of_quadratic(buffers));
  gl::ComputePass pass = over_deferred(kernel, defines_of_quadratic(std::move(defines), buffers), std::move(bindings),
                                       buffers.has_linear(), buffers.quadratic_count, std::move(constants));
  pass.loops(loops_of_quadratic());
  return pass;
}

std::pair<gl::Defines, gl::ComputePass::Bindings> Recording::deferring(gl::Defines defines,
                                                                       gl::ComputePass::Bindings bindings) const {
  defines.emplace_back("DEFERS", "1");
  bindings.emplace_back("deferred", &deferred->lists);
  return {std::move(defines), std::move(bindings)};
}

gl::ComputePass Recording::over_deferred(const char* kernel, gl::Defines defines, gl::ComputePass::Bindings bindings,
                                         std::uint32_t list, std::uint32_t most,
                                         gl::ComputePass::Constants constants) const {
  defines.emplace_back("DEFERRED", "1");
  bindings.emplace_back("deferred_items", &deferred->lists);
  gl::ComputePass pass(programs.compute(kernel, defines), std::move(bindings), most, std::move(constants));
  pass.set_indirect(deferred->lists, 4 * list);
  return pass;
}

gl::ComputePass Recording::sum_over_vertices(const char* kernel, gl::Defines defines,
                                             gl::ComputePass::Bindings bindings, const Reduction& sum,
                                             gl::ComputePass::Constants constants) const {
  if (active) list(defines, bindings, active->vertices);
  constants.emplace_back("vertex_count", buffers.vertex_count);
  gl::ComputePass pass(programs.compute(kernel, defines), std::move(bindings), sum.lanes, std::move(constants));
  pass.loops(loops_of_sum(buffers.vertex_count, sum, 9));  // a vertex is in the support of eight coarse nodes
  if (active) pass.follow("vertex_count", active->vertex_count);
  return pass;
}

gl::ComputePass Recording::sum_over_pairs(const char* kernel, gl::Defines defines, gl::ComputePass::Bindings bindings,
                                          const Reduction& sum, gl::ComputePass::Constants constants) const {
  if (active) list(defines, bindings, active->pairs);
  append(constants, constants_of_pairs(buffers));
  constants.emplace_back("pair_and_single_count", buffers.pair_and_single_count());
  gl::ComputePass pass(programs.compute(kernel, defines), std::move(bindings), sum.lanes, std::move(constants));
  pass.loops(loops_of_sum(buffers.pair_and_single_count(), sum, deferred ? 0 : loops_of_pair()));
  count_bytes_of_pairs(pass, buffers);
  if (active) pass.follow("pair_and_single_count", active->pair_count);
  return pass;
}

gl::ComputePass Recording::sum_over_quadratic(const char* kernel, gl::Defines defines,
                                              gl::ComputePass::Bindings bindings, const Reduction& sum,
                                              gl::ComputePass::Constants constants) const {
  if (active) list(defines, bindings, active->quadratic);
  append(constants, constants_of_quadratic(buffers));
  constants.emplace_back("quadratic_count", buffers.quadratic_count);
  gl::ComputePass pass(programs.compute(kernel, defines_of_quadratic(std::move(defines), buffers)), std::move(bindings),
                       sum.lanes, std::move(constants));
  pass.loops(loops_of_sum(buffers.quadratic_count, sum, deferred ? kPoints : loops_of_quadratic()));
  if (active) pass.follow("quadratic_count", active->quadratic_count);
  return pass;
}

}  // namespace fascia
