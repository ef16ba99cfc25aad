#include "sim/gpu/acceleration/anderson.h"

#include <algorithm>

#include "sim/gpu/passes/reduction.h"
#include "sim/scene/settings/solver_settings.h"

namespace fascia {
namespace {

constexpr std::size_t kStateBytes = (3 + kLargestWindow + kLargestWindow * kLargestWindow) * sizeof(float);

Reduction reduction_of(const gl::ProgramCache& programs, const std::vector<AndersonPart>& parts) {
  const auto largest =
      std::max_element(parts.begin(), parts.end(), [](const auto& a, const auto& b) { return a.count < b.count; });
  return {programs, largest->count};
}

}  // namespace

Anderson::Anderson(const gl::ProgramCache& programs, std::vector<AndersonPart> parts, int window)
    : parts_(std::move(parts)),
      window_(static_cast<std::uint32_t>(window)),
      lanes_(reduction_of(programs, parts_).lanes),
      partials_(reduction_of(programs, parts_).partials),
      dot_partials_("anderson_dot_partials", sizeof(shared::vec4) * partials_ * window_ * parts_.size()),
      state_("anderson_state", kStateBytes) {
  for (const AndersonPart& part : parts_) {
    const std::size_t bytes = sizeof(shared::vec4) * part.count;
    histories_.push_back({gl::Buffer("anderson_iterate", bytes), gl::Buffer("anderson_residual", bytes),
                          gl::Buffer("anderson_image", bytes), gl::Buffer("anderson_residual_change", bytes * window_),
                          gl::Buffer("anderson_image_change", bytes * window_)});
  }
}

Passes Anderson::begin(gl::ProgramCache& programs) const {
  Passes passes;
  for (std::size_t p = 0; p < parts_.size(); ++p)
    passes
        .emplace_back(programs.compute("sim/acceleration/anderson_mark.comp"),
                      gl::ComputePass::Bindings{{"value", parts_[p].value}, {"iterate", &histories_[p].iterate}},
                      parts_[p].count)
        .loops(0);
  return passes;
}

Passes Anderson::passes(gl::ProgramCache& programs, bool first) const {
  Passes passes;
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    const AndersonPart& part = parts_[p];
    const History& history = histories_[p];
    const gl::Defines weighted{{"WEIGHTED", part.weight ? "1" : "0"}};
    gl::ComputePass::Bindings difference{{"value", part.value},
                                         {"iterate", &history.iterate},
                                         {"residual", &history.residual},
                                         {"image", &history.image},
                                         {"anderson_state", &state_}};
    if (part.weight) difference.emplace_back("weight", part.weight);
    if (first) {
      difference.emplace_back("start", &history.iterate);
      passes
          .emplace_back(programs.compute("sim/acceleration/anderson_begin.comp", weighted), std::move(difference),
                        part.count)
          .loops(0);
      continue;
    }
    difference.emplace_back("residual_before", &history.residual);
    difference.emplace_back("image_before", &history.image);
    difference.emplace_back("residual_change", &history.residual_change);
    difference.emplace_back("image_change", &history.image_change);
    passes
        .emplace_back(programs.compute("sim/acceleration/anderson_difference.comp", weighted), std::move(difference),
                      part.count)
        .loops(0);
    passes
        .emplace_back(
            programs.compute("sim/acceleration/anderson_dots.comp"),
            gl::ComputePass::Bindings{{"anderson_state", &state_},
                                      {"residual", &history.residual},
                                      {"residual_change", &history.residual_change},
                                      {"image", &history.image},
                                      {"dot_partials", &dot_partials_}},
            lanes_ * window_,
            gl::ComputePass::Constants{{"vector_count", part.count},
                                       {"lanes", lanes_},
                                       {"first_partial", static_cast<std::uint32_t>(p) * window_ * partials_}})
        .loops(part.count / lanes_ + 2);
  }
  if (first) return passes;
  constexpr std::uint32_t kLeastWidth = 4;  // invocations per vector, which share the columns
  passes
      .emplace_back(
          programs.compute("sim/acceleration/anderson_solve.comp"),
          gl::ComputePass::Bindings{{"dot_partials", &dot_partials_}, {"anderson_state", &state_}}, 1,
          gl::ComputePass::Constants{
              {"window", window_}, {"partials", partials_}, {"parts", static_cast<std::uint32_t>(parts_.size())}})
      .loops((window_ / kLeastWidth + 1) * static_cast<std::uint32_t>(parts_.size()) * (partials_ + 1) +
             window_ * window_ * (window_ + 8));
  for (std::size_t p = 0; p < parts_.size(); ++p)
    passes
        .emplace_back(programs.compute("sim/acceleration/anderson_apply.comp"),
                      gl::ComputePass::Bindings{{"anderson_state", &state_},
                                                {"image", &histories_[p].image},
                                                {"image_change", &histories_[p].image_change},
                                                {"iterate", &histories_[p].iterate},
                                                {"value", parts_[p].value}},
                      parts_[p].count)
        .loops(window_);
  return passes;
}

}  // namespace fascia
