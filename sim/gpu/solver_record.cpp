// Records the passes of the solver's steps: with all tets or a part of them, with contact or without.
#include <algorithm>

#include "sim/coarse/linear_model.h"
#include "sim/gpu/solver.h"

namespace fascia {

void GpuSolver::record() {
  const bool extrapolates = info_of(settings_.integrator).extrapolates;
  if (!extrapolates) earlier_step_ = 0;
  buffers_.keep_earlier(extrapolates);
  if (!features_.damping) previous_strain_ = {};
  if (features_.damping && !previous_strain_)
    previous_strain_ = gl::Buffer("previous_strain", bytes_of_previous_strain(programs_, buffers_));
  const bool may_rest = method_->may_rest_in_regions() && !stop_ && settings_.rest_speed > 0 &&
                        !buffers_.displacement_low && !contact_.searches() &&
                        buffers_.work() >= RestingRegions::kLeastTets && !always_whole_;
  if (!may_rest) regions_.reset();
  if (may_rest && !regions_) regions_.emplace(programs_, buffers_);
  fuses_ = !stop_ && gl::fuses(programs_);
  // A GPU skips a branch that no neighboring invocation takes; a second dispatch and its copies would only add cost.
  const bool branches_skip = programs_.sums_in_groups();
  const Deferral most_deferred = method_->most_deferred(buffers_, fuses_);
  const bool may_defer =
      features_.models.contains(MaterialModel::signed_st_venant_kirchhoff) && most_deferred.items > 0 && !branches_skip;
  if (!may_defer) deferred_.reset();
  if (may_defer && (!deferred_ || deferred_->most != most_deferred)) deferred_.emplace(most_deferred);
  relaxes_ = may_relax();
  method_->relax(model_, relaxes_);
  if (!relaxes_) buffers_.forget_multipliers();
  method_->prepare(recording(nullptr, true));
  buffers_.correction.clear();  // kernels may leave its w unchanged
  before_every_ = 1;
  const bool first = !whole_.passes.recorded() && !apart_.passes.recorded();
  StepKind& kind = contact_.acts() && (first ? !is_near() : !touches()) ? apart_ : whole_;
  if (first && watch_) watch_->restart();
  whole_ = apart_ = partial_ = partial_apart_ = {};
  take(kind);
  if (!features_.models.contains(MaterialModel::squared)) {
    tangles_.reset();
    set_hardness(Hardness::own);
  } else if (!tangles_) {
    tangles_.emplace(programs_, buffers_);
  }
  contact_.record_loads(programs_);
  diagnostics_.record(programs_, buffers_, features_, previous_strain_, terms_);
  surface_.record(programs_, buffers_, features_, color_, contact_);
  published_ = false;
}

// The residual of a stop rule is that of the present multipliers.
bool GpuSolver::may_relax() const { return !stop_ && !buffers_.displacement_low && has_large_bulk(model_); }

void GpuSolver::record(StepKind& kind) {
  const bool partial = &kind == &partial_ || &kind == &partial_apart_;
  kind.passes = record_step(partial ? &regions_->active() : nullptr, &kind == &whole_ || &kind == &partial_);
  kind.fused = partial && !programs_.fusing_rare() ? std::nullopt : fuse(kind.passes);
}

std::optional<GpuSolver::FusedStep> GpuSolver::fuse(const StepPasses& passes) {
  if (!fuses_) return std::nullopt;
  const auto joined = [&](std::initializer_list<const Passes*> lists) {
    Passes all;
    for (const Passes* list : lists) append(all, *list);
    return gl::FusedPasses(programs_, all);
  };
  return FusedStep{joined({&passes.begin}),   joined({&passes.relist}),
                   joined({&passes.again}),   joined({&passes.before_first, &passes.first_iteration}),
                   joined({&passes.refresh}), joined({&passes.before, &passes.iteration}),
                   joined({&passes.check}),   joined({&passes.end}),
                   joined({&passes.renew})};
}

Start GpuSolver::start() {
  if (!method_->starts_without_gravity() || parts_.held_parts == 0) return {};
  if (parts_.parts == 0) return {false};
  if (!unconstrained_) unconstrained_ = gl::Buffer("unconstrained", parts_.part);
  return {false, &unconstrained_};
}

Recording GpuSolver::recording(const ActiveSet* active, bool contact) {
  const EnergyTerms& terms = contact ? terms_ : terms_apart_;
  return {programs_, buffers_, features_, previous_strain_, terms, deferred_ ? &*deferred_ : nullptr, active};
}

GpuSolver::StepPasses GpuSolver::record_step(const ActiveSet* active, bool contact) {
  const gl::ProgramCache::Postponed postponed(
      programs_);  // kernels that are part of another program need none of their own
  const Recording r = recording(active, contact);
  StepPasses passes;
  const bool strains_first = buffers_.earlier_displacement && features_.damping;
  if (strains_first) append(passes.begin, strains_at_start(r));
  passes.begin.push_back(prediction(programs_, buffers_, method_->copy_begin(), start(), active));
  if (buffers_.has_quadratic()) passes.begin.push_back(centroid_prediction(r));
  if (!motions_.empty()) passes.begin.push_back(motions_.pass(programs_, buffers_));
  if (features_.damping && !strains_first) append(passes.begin, strains_at_start(r));
  if (contact_.searches()) {
    passes.relist = r.beginnings();
    passes.again = method_->begin(r);
  }
  append(passes.begin, r.beginnings());
  append(passes.begin, method_->begin(r));
  passes.before_first = method_->before(r, true);
  passes.before = method_->before(r, false);
  passes.refresh = method_->refresh(r);
  if (multiplier_weight_) {
    gl::ComputePass::Bindings bindings{{"step", &buffers_.step},
                                       {"tet_vertices", &buffers_.tet_vertices},
                                       {"tet_shape", &buffers_.tet_shape},
                                       {"multiplier_weight", &multiplier_weight_}};
    passes.begin.push_back(r.over_tets("sim/acceleration/multiplier_weight.comp", defines_of(features_),
                                       with_material(std::move(bindings), features_, buffers_)));
    passes.begin.back().loops(0);
  }
  if (acceleration_) append(passes.begin, acceleration_->begin(r));
  passes.first_iteration = iteration(r, true);
  passes.iteration = iteration(r, false);
  passes.renew = method_->renew(r);
  passes.completion = method_->complete_iteration(r);
  const bool moves_bodies = method_->descends() && !active && bodies_.may_move() && !buffers_.displacement_low;
  const bool looks = contact_.searches() || moves_bodies;
  Passes& last = looks ? passes.check : passes.end;
  last = method_->end(r);
  if (stop_) {
    stop_->record(r, passes.before_first, passes.before,
                  {&passes.refresh, &passes.first_iteration, &passes.iteration, &passes.completion, &last});
    before_every_ = stop_->interval();
  }
  append(passes.end, r.endings(moves_bodies));
  passes.end.push_back(velocity_update(r));
  if (!fuses_ || (active && !programs_.fusing_rare()))
    for (const Passes* list : passes.lists())
      for (const gl::ComputePass& pass : *list) pass.program().begin_link();
  return passes;
}

bool GpuSolver::ready() const {
  const auto idle = [](const Passes* list) {
    return std::all_of(list->begin(), list->end(), [](const gl::ComputePass& pass) { return pass.program().idle(); });
  };
  const auto lists = kind_->passes.lists();
  return method_->ready() && std::all_of(lists.begin(), lists.end(), idle);
}

Passes GpuSolver::iteration(const Recording& r, bool first) {
  Passes passes = method_->iteration(r, first);
  // Chebyshev acceleration is for methods whose iterations start at the prediction.
  if (acceleration_) append(passes, acceleration_->after_iteration(r, first));
  return passes;
}

}  // namespace fascia
