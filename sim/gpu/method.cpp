#include "sim/gpu/method.h"

namespace fascia {
namespace {

void list(gl::Defines& defines, gl::ComputePass::Bindings& bindings, const gl::Buffer& items) {
  defines.emplace_back("LISTED", "1");
  bindings.emplace_back("item_list", &items);
}

}  // namespace

gl::ComputePass Recording::over_vertices(const char* kernel, gl::Defines defines, gl::ComputePass::Bindings bindings) const {
  if (active) list(defines, bindings, active->vertices);
  gl::ComputePass pass(programs.compute(kernel, defines), std::move(bindings), buffers.vertex_count);
  if (active) pass.follow("invocations", active->vertex_count);
  return pass;
}

gl::ComputePass Recording::over_tets(const char* kernel, gl::Defines defines, gl::ComputePass::Bindings bindings) const {
  return {programs.compute(kernel, defines), std::move(bindings), buffers.tet_count};
}

gl::ComputePass Recording::over_pairs(const char* kernel, gl::Defines defines, gl::ComputePass::Bindings bindings) const {
  if (active) list(defines, bindings, active->pairs);
  gl::ComputePass pass(programs.compute(kernel, defines), std::move(bindings), buffers.pair_and_single_count(),
                       {{"pair_count", buffers.pair_count}});
  if (active) pass.follow("invocations", active->pair_count);
  return pass;
}

Passes Recording::over_pairs_deferring(const char* kernel, const gl::Defines& defines, const gl::ComputePass::Bindings& bindings) const {
  if (!deferred) return {over_pairs(kernel, defines, bindings)};
  auto [first_defines, first_bindings] = deferring(defines, bindings);
  Passes passes{over_pairs(kernel, std::move(first_defines), std::move(first_bindings))};
  passes.back().copy_first(deferred->none, deferred->count);
  passes.push_back(over_deferred(kernel, defines, bindings));
  return passes;
}

gl::ComputePass Recording::over_deferred(const char* kernel, gl::Defines defines, gl::ComputePass::Bindings bindings) const {
  return over_deferred(kernel, std::move(defines), std::move(bindings), buffers.pair_and_single_count(), {{"pair_count", buffers.pair_count}});
}

Passes Recording::over_range_deferring(const char* kernel, const gl::Defines& defines, const gl::ComputePass::Bindings& bindings,
                                       std::uint32_t first_item, std::uint32_t count) const {
  const gl::ComputePass::Constants constants{{"first_item", first_item}};
  if (!deferred) return {{programs.compute(kernel, defines), bindings, count, constants}};
  auto [first_defines, first_bindings] = deferring(defines, bindings);
  Passes passes{{programs.compute(kernel, first_defines), std::move(first_bindings), count, constants}};
  passes.back().copy_first(deferred->none, deferred->count);
  passes.push_back(over_deferred(kernel, defines, bindings, count, constants));
  return passes;
}

std::pair<gl::Defines, gl::ComputePass::Bindings> Recording::deferring(gl::Defines defines, gl::ComputePass::Bindings bindings) const {
  defines.emplace_back("DEFERS", "1");
  bindings.insert(bindings.end(), {{"deferred_items", &deferred->items}, {"deferred_counts", &deferred->count}});
  return {std::move(defines), std::move(bindings)};
}

gl::ComputePass Recording::over_deferred(const char* kernel, gl::Defines defines, gl::ComputePass::Bindings bindings, std::uint32_t most,
                                         gl::ComputePass::Constants constants) const {
  defines.emplace_back("DEFERRED", "1");
  bindings.insert(bindings.end(), {{"deferred_item", &deferred->items}, {"deferred_count", &deferred->count}});
  gl::ComputePass pass(programs.compute(kernel, defines), std::move(bindings), most, std::move(constants));
  pass.set_indirect(deferred->count, 0);
  return pass;
}

gl::ComputePass Recording::sum_over_vertices(const char* kernel, gl::Defines defines, gl::ComputePass::Bindings bindings,
                                             const Reduction& sum, gl::ComputePass::Constants constants) const {
  if (active) list(defines, bindings, active->vertices);
  constants.emplace_back("vertex_count", buffers.vertex_count);
  gl::ComputePass pass(programs.compute(kernel, defines), std::move(bindings), sum.lanes, std::move(constants));
  if (active) pass.follow("vertex_count", active->vertex_count);
  return pass;
}

gl::ComputePass Recording::sum_over_pairs(const char* kernel, gl::Defines defines, gl::ComputePass::Bindings bindings,
                                         const Reduction& sum) const {
  if (active) list(defines, bindings, active->pairs);
  gl::ComputePass pass(programs.compute(kernel, defines), std::move(bindings), sum.lanes,
                       {{"pair_count", buffers.pair_count}, {"pair_and_single_count", buffers.pair_and_single_count()}});
  if (active) pass.follow("pair_and_single_count", active->pair_count);
  return pass;
}

}  // namespace fascia
