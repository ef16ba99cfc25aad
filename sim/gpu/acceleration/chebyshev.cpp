#include "sim/gpu/acceleration/chebyshev.h"

#include "sim/gpu/passes/reduction.h"

namespace fascia {
namespace {

constexpr std::size_t kStateFloats = 6, kRadius = 1;  // as in chebyshev_state.glsl

}  // namespace

Chebyshev::Chebyshev(const gl::ProgramCache& programs, std::uint32_t vertex_count)
    : vertex_count_(vertex_count),
      lanes_(Reduction(programs, vertex_count).lanes),
      partials_(Reduction(programs, vertex_count).partials),
      iterate_("chebyshev_iterate", sizeof(shared::vec4) * vertex_count),
      before_("chebyshev_before", sizeof(shared::vec4) * vertex_count),
      square_partials_("chebyshev_square_partials", sizeof(shared::vec4) * partials_),
      state_("chebyshev_state", kStateFloats * sizeof(float)) {}

std::vector<gl::ComputePass> Chebyshev::passes(gl::ProgramCache& programs, const gl::Buffer& step,
                                               const gl::Buffer& start, const gl::Buffer& displacement,
                                               bool first) const {
  std::vector<gl::ComputePass> passes;
  passes
      .emplace_back(programs.compute("sim/acceleration/chebyshev_difference.comp"),
                    gl::ComputePass::Bindings{{"displacement", &displacement},
                                              {"start", first ? &start : &iterate_},
                                              {"square_partials", &square_partials_}},
                    lanes_, gl::ComputePass::Constants{{"vertex_count", vertex_count_}})
      .loops(vertex_count_ / lanes_ + 2);
  passes
      .emplace_back(
          programs.compute("sim/acceleration/chebyshev_weight.comp", {{"FIRST_ITERATION", first ? "1" : "0"}}),
          gl::ComputePass::Bindings{
              {"step", &step}, {"square_partials", &square_partials_}, {"chebyshev_state", &state_}},
          1, gl::ComputePass::Constants{{"partials", partials_}})
      .loops(partials_ + Reduction::kGroup);
  gl::ComputePass::Bindings apply{{"displacement", &displacement}, {"iterate", &iterate_}, {"before", &before_}};
  if (first)
    apply.emplace_back("start", &start);
  else
    apply.insert(
        apply.end(),
        {{"chebyshev_state", &state_}, {"swept", &displacement}, {"current", &iterate_}, {"earlier", &before_}});
  passes
      .emplace_back(
          programs.compute(first ? "sim/acceleration/chebyshev_begin.comp" : "sim/acceleration/chebyshev_apply.comp"),
          std::move(apply), vertex_count_)
      .loops(0);
  return passes;
}

void Chebyshev::forget_spectral_radius() {
  const float unknown = 0;
  state_.upload(kRadius * sizeof unknown, sizeof unknown, &unknown);
}

double Chebyshev::spectral_radius() const {
  float radius = 0;
  state_.download(kRadius * sizeof radius, sizeof radius, &radius);
  return radius;
}

}  // namespace fascia
