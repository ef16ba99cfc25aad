#include "sim/gpu/anderson_positions.h"

#include "sim/gpu/reduction.h"
#include "sim/settings.h"

namespace fascia {
namespace {

constexpr std::size_t kVector = sizeof(shared::vec4);
constexpr std::size_t kStateBytes = (3 + kLargestWindow + kLargestWindow * kLargestWindow) * sizeof(float);

}  // namespace

AndersonPositions::AndersonPositions(const gl::ProgramCache& programs, std::uint32_t vertex_count, int window)
    : vertex_count_(vertex_count),
      window_(static_cast<std::uint32_t>(window)),
      lanes_(Reduction(programs, vertex_count).lanes),
      partials_(Reduction(programs, vertex_count).partials),
      iterate_("anderson_iterate", kVector * vertex_count),
      residual_("anderson_residual", kVector * vertex_count),
      image_("anderson_image", kVector * vertex_count),
      residual_change_("anderson_residual_change", kVector * vertex_count * window_),
      image_change_("anderson_image_change", kVector * vertex_count * window_),
      dot_partials_("anderson_dot_partials", kVector * partials_ * window_),
      state_("anderson_state", kStateBytes) {}

std::vector<gl::ComputePass> AndersonPositions::passes(gl::ProgramCache& programs, const gl::Buffer& start,
                                                       const gl::Buffer& displacement, bool first) const {
  gl::ComputePass::Bindings difference{{"displacement", &displacement},
                                       {"iterate", &iterate_},
                                       {"residual", &residual_},
                                       {"image", &image_},
                                       {"anderson_state", &state_}};
  std::vector<gl::ComputePass> passes;
  if (first) {
    difference.emplace_back("start", &start);
    passes.emplace_back(programs.compute("sim/anderson_begin.comp"), std::move(difference), vertex_count_);
    return passes;
  }
  difference.emplace_back("residual_change", &residual_change_);
  difference.emplace_back("image_change", &image_change_);
  passes.emplace_back(programs.compute("sim/anderson_difference.comp"), std::move(difference), vertex_count_);
  passes.emplace_back(programs.compute("sim/anderson_dots.comp"),
                      gl::ComputePass::Bindings{{"anderson_state", &state_},
                                                {"residual", &residual_},
                                                {"residual_change", &residual_change_},
                                                {"dot_partials", &dot_partials_}},
                      lanes_ * window_, gl::ComputePass::Constants{{"vertex_count", vertex_count_}, {"lanes", lanes_}});
  passes.emplace_back(programs.compute("sim/anderson_solve.comp"),
                      gl::ComputePass::Bindings{{"dot_partials", &dot_partials_}, {"anderson_state", &state_}},
                      Reduction::kGroup, gl::ComputePass::Constants{{"window", window_}, {"partials", partials_}});
  passes.emplace_back(programs.compute("sim/anderson_apply.comp"),
                      gl::ComputePass::Bindings{{"anderson_state", &state_},
                                                {"image", &image_},
                                                {"image_change", &image_change_},
                                                {"iterate", &iterate_},
                                                {"displacement", &displacement}},
                      vertex_count_);
  return passes;
}

}  // namespace fascia
