#include "sim/gpu/methods/gauss_seidel.h"

#include "sim/gpu/methods/methods.h"

#include <algorithm>
#include <numeric>
#include <string>

#include "sim/ordering/morton_order.h"

namespace fascia {
namespace {

Coloring color(const Model& model, const std::vector<std::uint32_t>& solved, int colors) {
  std::vector<Tet> tets;
  for (const std::uint32_t t : solved) tets.push_back(model.tets[t]);
  std::vector<std::uint32_t> visit(solved.size());
  std::iota(visit.begin(), visit.end(), 0u);
  return color_tets(tets, model.held(), visit, static_cast<std::uint32_t>(colors));
}

}  // namespace

GaussSeidelMethod::GaussSeidelMethod(const Model& model, SimBuffers& buffers, int colors)
    : colors_asked_(colors), multiplier_("multiplier", 2 * sizeof(shared::vec4) * buffers.tet_count) {
  std::vector<std::uint32_t> order = solved_tets(model);
  coloring_ = color(model, order, colors);
  phantom_count_ = static_cast<std::uint32_t>(coloring_.phantom_vertex.size());
  std::transform(coloring_.order.begin(), coloring_.order.end(), order.begin(),
                 [solved = order](std::uint32_t k) { return solved[k]; });
  buffers.set_tet_order(model, {std::move(order), 0});
  buffers.set_phantom_count(phantom_count_);
  if (phantom_count_ == 0) return;
  std::vector<Tet> corners;
  for (const std::uint32_t t : coloring_.order) corners.push_back(coloring_.corners[t]);
  std::vector<std::uint32_t> copy_begin(buffers.vertex_count + 1), split;
  for (const std::uint32_t v : coloring_.phantom_vertex) {
    ++copy_begin[v + 1];
    if (split.empty() || split.back() != v) split.push_back(v);
  }
  for (std::uint32_t v = 0; v < buffers.vertex_count; ++v) copy_begin[v + 1] += copy_begin[v] + 1;
  corners_ = gl::Buffer("color_corners", corners);
  phantom_vertex_ = gl::Buffer("phantom_vertex", coloring_.phantom_vertex);
  copy_begin_ = gl::Buffer("copy_begin", copy_begin);
  split_vertex_ = gl::Buffer("split_vertex", split);
  split_count_ = static_cast<std::uint32_t>(split.size());
}

bool GaussSeidelMethod::goes_on_with(const MethodInputs& inputs) { return inputs.settings.colors == colors_asked_; }

Deferral GaussSeidelMethod::most_deferred(const SimBuffers& buffers, bool fused) const {
  return fused ? Deferral{static_cast<std::uint32_t>(coloring_.color_count()), buffers.tet_count} : Deferral{};
}

Passes GaussSeidelMethod::iteration(const Recording& r, bool first) const {
  gl::Defines defines = defines_of(r.features);
  defines.emplace_back("FIRST_ITERATION", first ? "1" : "0");
  // On software renderers invocations without a tet take as long as the others, and in small colors most invocations of
  // a group have none.
  constexpr std::size_t kSmall = 32;  // tets of a color
  if (coloring_.order.size() <= kSmall * coloring_.color_count())
    defines.emplace_back("GROUP_SIZE", std::to_string(kSmall));
  gl::ComputePass::Bindings bindings{{"step", &r.buffers.step},
                                     {"tet_vertices", phantom_count_ ? &corners_ : &r.buffers.tet_vertices},
                                     {"tet_shape", &r.buffers.tet_shape},
                                     {"lambda", &multiplier_},
                                     {"multiplier", &multiplier_},
                                     {"corner", &r.buffers.displacement},
                                     {"displacement", &r.buffers.displacement}};
  bindings = with_damping(with_material(std::move(bindings), r.features, r.buffers), r.features, r.previous_strain);
  Passes passes;
  if (phantom_count_)
    passes
        .emplace_back(
            r.programs.compute("sim/xpbd/split_phantoms.comp"),
            gl::ComputePass::Bindings{{"phantom_vertex", &phantom_vertex_}, {"displacement", &r.buffers.displacement}},
            phantom_count_, gl::ComputePass::Constants{{"first_item", r.buffers.vertex_count}})
        .loops(0);
  append(passes, r.over_ranges_deferring("sim/xpbd/gauss_seidel.comp", defines, bindings, coloring_.begin, 0, 1));
  if (phantom_count_)
    passes
        .emplace_back(r.programs.compute("sim/xpbd/merge_phantoms.comp"),
                      gl::ComputePass::Bindings{{"split_vertex", &split_vertex_},
                                                {"copy_begin", &copy_begin_},
                                                {"displacement", &r.buffers.displacement}},
                      split_count_, gl::ComputePass::Constants{{"first_item", r.buffers.vertex_count}})
        .loops(r.loops_of_vertex());
  append(passes, r.projections(first));
  return passes;
}

}  // namespace fascia
