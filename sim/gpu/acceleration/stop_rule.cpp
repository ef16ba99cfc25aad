#include "sim/gpu/acceleration/stop_rule.h"

namespace fascia {

StopRule::StopRule(const gl::ProgramCache& programs, const SimBuffers& buffers, const StepGradient* gradient)
    : own_(gradient ? std::nullopt : std::optional<StepGradient>(std::in_place, programs, buffers)),
      gradient_(gradient ? gradient->gradient() : own_->gradient()),
      sums_(programs, buffers.vertex_count),
      residual_partials_("residual_partials", 2 * sizeof(shared::vec4) * sums_.partials),
      state_("stop_state", 2 * sizeof(std::uint32_t)) {}

Passes StopRule::check(const Recording& r, bool first, std::uint32_t pass_count) const {
  Passes passes;
  if (own_) passes = own_->passes(r);
  gl::ComputePass::Bindings bindings{{"step", &r.buffers.step},
                                     {"gradient", &gradient_},
                                     {"displacement", &r.buffers.displacement},
                                     {"predicted", &r.buffers.predicted},
                                     {"velocity", &r.buffers.velocity},
                                     {"mass", &r.buffers.mass},
                                     {"residual_partials", &residual_partials_}};
  const gl::Defines defines = with_energy_terms({}, bindings, r.terms, TermUse::gradient);
  passes.emplace_back(
      r.programs.compute("sim/acceleration/stop_residual.comp", defines), std::move(bindings), sums_.lanes,
      gl::ComputePass::Constants{{"vertex_count", r.buffers.vertex_count}, {"partials", sums_.partials}});
  passes.emplace_back(r.programs.compute("sim/acceleration/stop_decide.comp", {{"FIRST_ITERATION", first ? "1" : "0"}}),
                      gl::ComputePass::Bindings{{"step", &r.buffers.step},
                                                {"residual_partials", &residual_partials_},
                                                {"full_groups", &full_groups_},
                                                {"dispatch_arguments", &arguments_},
                                                {"stop_state", &state_}},
                      1,
                      gl::ComputePass::Constants{{"partials", sums_.partials},
                                                 {"pass_count", pass_count},
                                                 {"interval", static_cast<std::uint32_t>(interval())}});
  return passes;
}

void StopRule::record(const Recording& r, Passes& before_first, Passes& before,
                      std::initializer_list<Passes*> governed) {
  std::size_t count = before.size() + (own_ ? own_->passes(r).size() : 0) + 2;
  for (const Passes* list : governed) count += list->size();
  full_groups_ = gl::Buffer("full_groups", count * sizeof(std::uint32_t));
  arguments_ = gl::Buffer("dispatch_arguments", std::vector<std::uint32_t>(3 * count, 1));
  append(before_first, check(r, true, static_cast<std::uint32_t>(count)));
  append(before, check(r, false, static_cast<std::uint32_t>(count)));
  std::vector<std::uint32_t> groups;
  const auto govern = [&](Passes& list) {
    for (gl::ComputePass& pass : list) {
      if (pass.arguments()) continue;  // already dispatched indirectly, without work if the passes before it have none
      pass.set_indirect(arguments_, static_cast<std::uint32_t>(3 * groups.size()));
      groups.push_back(pass.groups());
    }
  };
  govern(before);
  for (Passes* list : governed) govern(*list);
  full_groups_.upload(0, groups.size() * sizeof(std::uint32_t), groups.data());
}

}  // namespace fascia
