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
