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
  if (active) list(defines, bindings, active->tets);
  gl::ComputePass pass(programs.compute(kernel, defines), std::move(bindings), buffers.tet_count);
  if (active) pass.follow("invocations", active->tet_count);
  return pass;
}

Passes Recording::over_tets_deferring(const char* kernel, const gl::Defines& defines, const gl::ComputePass::Bindings& bindings) const {
  if (!deferred) return {over_tets(kernel, defines, bindings)};
  Passes passes;
  gl::Defines first_defines = defines;
  first_defines.emplace_back("DEFERS", "1");
  gl::ComputePass::Bindings first_bindings = bindings;
  first_bindings.insert(first_bindings.end(), {{"deferred_items", &deferred->tets}, {"deferred_counts", &deferred->count}});
  passes.push_back(over_tets(kernel, std::move(first_defines), std::move(first_bindings)));
  passes.back().copy_first(deferred->none, deferred->count);
  passes.push_back(over_deferred(kernel, defines, bindings));
  return passes;
}

gl::ComputePass Recording::over_deferred(const char* kernel, gl::Defines defines, gl::ComputePass::Bindings bindings) const {
  defines.emplace_back("DEFERRED", "1");
  bindings.insert(bindings.end(), {{"deferred_item", &deferred->tets}, {"deferred_count", &deferred->count}});
  gl::ComputePass pass(programs.compute(kernel, defines), std::move(bindings), buffers.tet_count);
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

gl::ComputePass Recording::sum_over_tets(const char* kernel, gl::Defines defines, gl::ComputePass::Bindings bindings,
                                         const Reduction& sum) const {
  if (active) list(defines, bindings, active->tets);
  gl::ComputePass pass(programs.compute(kernel, defines), std::move(bindings), sum.lanes, {{"tet_count", buffers.tet_count}});
  if (active) pass.follow("tet_count", active->tet_count);
  return pass;
}

}  // namespace fascia
