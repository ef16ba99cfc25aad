#include "sim/gpu/methods/two_level.h"

#include "sim/gpu/methods/methods.h"

namespace fascia {
namespace {

using shared::vec4;
constexpr std::size_t kSubspaceFloats = 8, kInContact = 10;  // shaders/sim/two_level/subspace_state.glsl

}  // namespace

TwoLevelMethod::TwoLevelMethod(const gl::ProgramCache& programs, const Model& model, const SimBuffers& buffers,
                               const SolverSettings& settings)
    : gradient_(programs, buffers),
      coarse_(programs, model, settings),
      block_inverse_("block_inverse", 2 * sizeof(vec4) * buffers.vertex_count),
      vertices_(programs, buffers.vertex_count, true),
      pairs_(programs, buffers.pair_and_single_count(), true),
      quadratic_(programs, buffers.quadratic_count, true),
      fine_direction_("fine_direction", gradient_.gradient().bytes()),
      last_step_("last_step", gradient_.gradient().bytes()),
      previous_gradient_("previous_gradient", gradient_.gradient().bytes()),
      partials_("subspace_partials", sizeof(vec4) * (3 * vertices_.partials + pairs_.partials + quadratic_.partials)),
      state_("subspace_state", kSubspaceFloats * sizeof(float)) {
  if (programs.sums_in_groups()) arrivals_ = gl::Buffer("arrivals", sizeof(std::uint32_t));
  if (buffers.has_linear()) vertex_tets_ = make_vertex_tets(buffers);
  if (buffers.has_quadratic()) vertex_quadratic_ = make_vertex_quadratic(buffers);
  set_acceleration(programs, buffers, settings);
}

bool TwoLevelMethod::goes_on_with(const MethodInputs& inputs) {
  set_acceleration(inputs.programs, inputs.buffers, inputs.settings);
  return true;
}

void TwoLevelMethod::set_acceleration(const gl::ProgramCache& programs, const SimBuffers& buffers,
                                      const SolverSettings& settings) {
  remembers_ = settings.acceleration == Acceleration::subspace || settings.acceleration == Acceleration::nonlinear_cg;
  splits_ = (settings.acceleration == Acceleration::subspace && !coarse_.empty()) ||
            settings.acceleration == Acceleration::anderson;
  coarse_direction_ = splits_ ? gl::Buffer("coarse_direction", fine_direction_.bytes()) : gl::Buffer();
  anderson_.reset();
  if (settings.acceleration == Acceleration::anderson)
    anderson_.emplace(programs, std::vector<AndersonPart>{{&fine_direction_, buffers.vertex_count, &buffers.mass}},
                      settings.window);
}

std::uint32_t TwoLevelMethod::term_partials(const Recording& r) const {
  std::uint32_t count = 0;
  for (const EnergyTerm* term : r.terms)
    if (term->acts()) count += term->curvature_partials(r.programs);
  return count;
}

void TwoLevelMethod::prepare(const Recording& r) {
  const std::size_t bytes =
      sizeof(vec4) * (3 * vertices_.partials + pairs_.partials + quadratic_.partials + term_partials(r));
  if (partials_.bytes() != bytes) partials_ = gl::Buffer("subspace_partials", bytes);
  const std::size_t state_bytes = sizeof(float) * (r.has_blocks() ? kInContact : kSubspaceFloats);
  if (state_.bytes() != state_bytes) state_ = gl::Buffer("subspace_state", state_bytes);
  const auto keep = [&](gl::Buffer& buffer, const char* name, std::uint32_t count) {
    if (!r.deferred || count == 0) buffer = {};
    if (!r.deferred || count == 0 || buffer) return;
    buffer = gl::Buffer(name, sizeof(vec4) * count);
    buffer.clear();
  };
  keep(guarded_curvature_, "guarded_curvature", r.buffers.pair_and_single_count());
  keep(guarded_quadratic_, "guarded_quadratic", r.buffers.quadratic_count);
  if (!r.has_blocks() || block_free_) return;
  block_free_ = gl::Buffer("block_free", block_inverse_.bytes());
  if (!r.evaluates_blocks()) block_pressed_ = gl::Buffer("block_pressed", block_inverse_.bytes());
}

// The inertial start may have a much higher energy: it is treated as a step from u_n, which is kept only if it lowers
// the objective.
Passes TwoLevelMethod::begin(const Recording& r) const {
  Passes passes;
  passes.push_back(r.over_vertices("sim/two_level/guess_begin.comp", {},
                                   {{"previous_displacement", &r.buffers.start_of_stage()},
                                    {"predicted", &r.buffers.predicted},
                                    {"last_step", &last_step_},
                                    {"iterate", &r.buffers.displacement},
                                    {"displacement", &r.buffers.displacement}}));
  if (relaxes_) passes.push_back(multipliers(r, false));
  append(passes, r.advances(last_step_));
  append(passes, gradient_.passes(r));
  passes.push_back(objective_sum(r, false));
  if (!last_group_ends(r))
    passes
        .emplace_back(r.programs.compute("sim/two_level/guess_objective.comp"),
                      gl::ComputePass::Bindings{{"dot_partials", &partials_}, {"subspace_state", &state_}}, 1,
                      gl::ComputePass::Constants{{"partials", vertices_.partials}})
        .loops(vertices_.partials + Reduction::kGroup);
  append(passes, r.evaluations());  // the stiffness that the iterations start with
  if (!coarse_.empty()) append(passes, coarse_.begin(r, gradient_.gradient()));
  return passes;
}

Passes TwoLevelMethod::refresh(const Recording& r) const {
  gl::ComputePass::Bindings bindings{{"step", &r.buffers.step},
                                     {"tet_vertices", &r.buffers.tet_vertices},
                                     {"tet_shape", &r.buffers.tet_shape},
                                     {"displacement", &r.buffers.displacement},
                                     {"mass", &r.buffers.own_masses()}};
  const bool contact = r.has_blocks(), at_once = contact && r.evaluates_blocks();
  if (contact) bindings.emplace_back("block_free", &block_free_);
  if (!contact || at_once) bindings.emplace_back("block_inverse", &block_inverse_);
  if (vertex_tets_)
    bindings.insert(bindings.end(), {{"tet_begin", &r.buffers.tet_begin}, {"vertex_tets", &vertex_tets_}});
  if (vertex_quadratic_)
    bindings.insert(bindings.end(), {{"mid_edges", &r.buffers.mid_edges},
                                     {"quadratic_begin", &r.buffers.quadratic_begin},
                                     {"vertex_quadratic", &vertex_quadratic_},
                                     {"multiplier", &r.buffers.multiplier},
                                     {"predicted_centroid", &r.buffers.predicted_centroid}});
  bindings = with_damping(with_material(std::move(bindings), r.features, r.buffers), r.features, r.previous_strain);
  gl::Defines defines =
      with_energy_terms(defines_of(r.features), bindings, r.terms, at_once ? TermUse::block : TermUse::stiffness);
  defines.emplace_back("FREE", contact ? "1" : "0");
  defines.emplace_back("LINEAR_TETS", vertex_tets_ ? "1" : "0");
  defines.emplace_back("QUADRATIC_TETS", vertex_quadratic_ ? "1" : "0");
  if (vertex_quadratic_) {
    defines = defines_of_quadratic(std::move(defines), r.buffers);
    defines.emplace_back("RELAXED", "1");
  }
  Passes passes;
  passes.push_back(
      r.over_vertices("sim/two_level/block_inverse.comp", std::move(defines), std::move(bindings),
                      vertex_quadratic_ ? constants_of_quadratic(r.buffers) : gl::ComputePass::Constants{}));
  passes.back().loops(r.loops_of_vertex());
  if (contact && !at_once) append(passes, blocks_in_contact(r, true));
  return passes;
}

Passes TwoLevelMethod::blocks_in_contact(const Recording& r, bool first) const {
  gl::ComputePass::Bindings bindings{{"step", &r.buffers.step},
                                     {"block_free", &block_free_},
                                     {"block_pressed", &block_pressed_},
                                     {"block_inverse", &block_inverse_}};
  EnergyTerms with_blocks;
  std::copy_if(r.terms.begin(), r.terms.end(), std::back_inserter(with_blocks),
               [](const EnergyTerm* term) { return term->acts() && term->has_blocks(); });
  gl::Defines defines = with_energy_terms({{"FIRST", first ? "1" : "0"}}, bindings, with_blocks, TermUse::block);
  constexpr const char* kKernel = "sim/two_level/block_contact.comp";
  if (!first) return with_blocks.front()->over_touched(r.programs, kKernel, std::move(defines), std::move(bindings));
  gl::ComputePass pass = r.over_vertices(kKernel, std::move(defines), std::move(bindings));
  pass.loops(r.loops_of_vertex());
  return {std::move(pass)};
}

Passes TwoLevelMethod::before(const Recording& r, bool first) const {
  const VertexBlocks blocks{block_free_, block_inverse_};
  return gradient_.passes(r, first ? std::nullopt : pending(r), first,  // begin() has evaluated the terms last
                          r.evaluates_blocks() ? &blocks : nullptr);
}

Passes TwoLevelMethod::iteration(const Recording& r, bool first) const {
  Passes passes;
  if (!first && r.has_blocks() && !r.evaluates_blocks()) append(passes, blocks_in_contact(r, false));
  if (!coarse_.empty()) append(passes, coarse_.passes(r, gradient_.gradient()));
  gl::Defines defines{
      {"COARSE", coarse_.empty() ? "0" : "1"}, {"SPLIT", splits_ ? "1" : "0"}, {"SWEEP", anderson_ ? "1" : "0"}};
  gl::ComputePass::Bindings correct{
      {"gradient", &gradient_.gradient()}, {"block_inverse", &block_inverse_}, {"fine_direction", &fine_direction_}};
  if (!coarse_.empty()) {
    correct.emplace_back("coarse_row_begin", &coarse_.row_begin());
    correct.emplace_back("coarse_rows", &coarse_.rows());
    correct.emplace_back("coarse_correction", &coarse_.correction());
  }
  if (splits_) correct.emplace_back("coarse_direction", &coarse_direction_);
  if (!anderson_) {
    passes.push_back(sum_for_step(r, "sim/two_level/two_level_correct.comp", std::move(defines), std::move(correct)));
  } else {
    correct.emplace_back("displacement", &r.buffers.displacement);
    correct.emplace_back("iterate", &anderson_->iterate(0));
    passes.push_back(r.over_vertices("sim/two_level/two_level_correct.comp", std::move(defines), std::move(correct)));
    passes.back().loops(9);
    append(passes, anderson_->passes(r.programs, first));
    passes
        .emplace_back(r.programs.compute("sim/two_level/sweep_direction.comp"),
                      gl::ComputePass::Bindings{{"displacement", &r.buffers.displacement},
                                                {"proposed", &fine_direction_},
                                                {"fine_direction", &fine_direction_}},
                      r.buffers.vertex_count)
        .loops(0);
    passes.push_back(sum_for_step(r, "sim/two_level/subspace_dots.comp", {},
                                  {{"gradient", &gradient_.gradient()},
                                   {"fine_direction", &fine_direction_},
                                   {"coarse_direction", &coarse_direction_}}));
  }
  append(passes, subspace_step(r, first, false));
  return passes;
}

Passes TwoLevelMethod::end(const Recording& r) const {
  Passes passes = gradient_.passes(r, pending(r));  // also reverts the last step if it raised the objective
  append(passes, subspace_step(r, false, true));
  return passes;
}

Passes TwoLevelMethod::renew(const Recording& r) const {
  if (!relaxes_) return {};
  Passes passes = end(r);
  passes.push_back(multipliers(r, true));
  const VertexBlocks blocks{block_free_, block_inverse_};
  append(passes, gradient_.passes(r, std::nullopt, false, r.evaluates_blocks() ? &blocks : nullptr));
  append(passes, iteration(r, true));
  return passes;
}

gl::ComputePass TwoLevelMethod::multipliers(const Recording& r, bool renews) const {
  gl::ComputePass::Bindings bindings{{"step", &r.buffers.step},
                                     {"displacement", &r.buffers.displacement},
                                     {"updated_multiplier", &r.buffers.multiplier}};
  if (renews) bindings.emplace_back("subspace_state", &state_);
  gl::Defines defines = defines_of(r.features);
  for (auto& [name, value] : defines)
    if (name == "DAMPING") value = "0";
  defines.emplace_back("RENEWS", renews ? "1" : "0");
  return r.over_quadratic("sim/quadratic/quadratic_multiplier.comp", std::move(defines),
                          with_quadratic(with_material(std::move(bindings), r.features, r.buffers), r.buffers));
}

Passes TwoLevelMethod::complete_iteration(const Recording& r) const {
  if (!gradient_moves(r)) return {};
  Passes passes{update(r, false)};
  passes.emplace_back(r.programs.compute("sim/two_level/subspace_applied.comp"),
                      gl::ComputePass::Bindings{{"subspace_state", &state_}}, 4);
  return passes;
}

// On GPUs sums end in the dispatch that adds their terms (shaders/common/last_group.glsl).
bool TwoLevelMethod::last_group_ends(const Recording& r) { return r.programs.sums_in_groups() && !r.deferred; }

// Not `final`: before the first step, which it then takes. The last group also keeps that objective or, with `final`,
// decides whether the last step is reverted.
gl::ComputePass TwoLevelMethod::objective_sum(const Recording& r, bool final) const {
  gl::ComputePass::Bindings bindings{{"gradient", &gradient_.gradient()}, {"dot_partials", &partials_}};
  if (!final)
    bindings.insert(bindings.end(), {{"last_step", &last_step_},
                                     {"previous_gradient", &previous_gradient_},
                                     {"iterate", &r.buffers.displacement},
                                     {"displacement", &r.buffers.displacement}});
  gl::Defines defines{{"FINAL", final ? "1" : "0"}};
  gl::ComputePass::Constants constants;
  if (last_group_ends(r)) {
    defines.emplace_back("LAST_GROUP", "1");
    bindings.insert(bindings.end(), {{"subspace_state", &state_}, {"arrivals", &arrivals_}});
    constants.emplace_back("partials", vertices_.partials);
  }
  return r.sum_over_vertices("sim/two_level/objective_sum.comp", std::move(defines), std::move(bindings), vertices_,
                             std::move(constants));
}

// A kernel that ends in the sums of sim/two_level/subspace_sums.glsl.
gl::ComputePass TwoLevelMethod::sum_for_step(const Recording& r, const char* kernel, gl::Defines defines,
                                             gl::ComputePass::Bindings bindings) const {
  bindings.insert(bindings.end(), {{"step", &r.buffers.step},
                                   {"mass", &r.buffers.own_masses()},
                                   {"last_step", &last_step_},
                                   {"previous_gradient", &previous_gradient_},
                                   {"dot_partials", &partials_}});
  defines = with_energy_terms(std::move(defines), bindings, r.terms, TermUse::stiffness);
  return r.sum_over_vertices(kernel, std::move(defines), std::move(bindings), vertices_,
                             {{"partials", vertices_.partials}});
}

// Of pairs of linear tets, or of quadratic ones. `defines` and `bindings`: those that both have. `solve`: of the step
// that the last group solves, or null.
Passes TwoLevelMethod::curvature(const Recording& r, bool quadratic, gl::Defines defines,
                                 gl::ComputePass::Bindings bindings, const StepSolve* solve) const {
  const char* const kernel =
      quadratic ? "sim/quadratic/quadratic_curvature.comp" : "sim/two_level/subspace_curvature.comp";
  const auto over_deferred = [&](const char* which, gl::Defines with, gl::ComputePass::Bindings more) {
    return quadratic ? r.over_deferred_quadratic(which, std::move(with), std::move(more))
                     : r.over_deferred(which, std::move(with), std::move(more));
  };
  const gl::Buffer& guarded = quadratic ? guarded_quadratic_ : guarded_curvature_;
  bindings = quadratic ? with_quadratic(std::move(bindings), r.buffers) : with_pairs(std::move(bindings), r.buffers);
  if (quadratic) {
    bindings.emplace_back("predicted_centroid", &r.buffers.predicted_centroid);
    bindings.emplace_back("multiplier", &r.buffers.multiplier);
    defines.emplace_back("RELAXED", "1");
  }
  gl::ComputePass::Bindings sums = bindings;
  gl::Defines sum_defines = defines;
  if (!solve) {
    sums.emplace_back("curvature_partials", &partials_);
  } else {
    sum_defines.emplace_back("LAST_GROUP", "1");
    sum_defines.insert(sum_defines.end(), solve->defines.begin(), solve->defines.end());
    sums.emplace_back("arrivals", &arrivals_);
    sums.insert(sums.end(), solve->bindings.begin(), solve->bindings.end());
  }
  Passes passes;
  if (r.deferred) {
    bindings.emplace_back("guarded_curvature", &guarded);
    passes.push_back(over_deferred(kernel, std::move(defines), std::move(bindings)));
    sums.emplace_back("guarded_terms", &guarded);
    sum_defines.emplace_back("GUARDED_ELSEWHERE", "1");
  }
  gl::ComputePass::Constants constants = solve ? solve->constants : gl::ComputePass::Constants{};
  constants.emplace_back("first_partial", 3 * vertices_.partials + (quadratic ? pairs_.partials : 0));
  passes.push_back(
      quadratic
          ? r.sum_over_quadratic(kernel, std::move(sum_defines), std::move(sums), quadratic_, std::move(constants))
          : r.sum_over_pairs(kernel, std::move(sum_defines), std::move(sums), pairs_, std::move(constants)));
  if (!r.deferred) return passes;
  passes.push_back(over_deferred("sim/two_level/guarded_curvature_clear.comp", {}, {{"guarded_curvature", &guarded}}));
  passes.back().loops(0);
  return passes;
}

Passes TwoLevelMethod::subspace_step(const Recording& r, bool first, bool last) const {
  Passes passes;
  StepSolve solve{{}, {{"dot_partials", &partials_}, {"subspace_state", &state_}}, {{"partials", vertices_.partials}}};
  std::uint32_t loops = vertices_.partials + pairs_.partials + quadratic_.partials + 2 * Reduction::kGroup;
  if (last) {
    passes.push_back(objective_sum(r, true));
  } else {
    const std::uint32_t of_terms = term_partials(r);
    loops += of_terms;
    solve.constants.emplace_back("curvature_count", pairs_.partials + quadratic_.partials + of_terms);
    solve.constants.emplace_back("remembers", remembers_ && !first);
    gl::ComputePass::Bindings curvature{
        {"step", &r.buffers.step}, {"displacement", &r.buffers.displacement}, {"fine_direction", &fine_direction_}};
    if (splits_) curvature.emplace_back("coarse_direction", &coarse_direction_);
    curvature = with_damping(with_material(std::move(curvature), r.features, r.buffers), r.features, r.previous_strain);
    gl::Defines curvature_defines = defines_of(r.features);
    curvature_defines.emplace_back("SPLIT", splits_ ? "1" : "0");
    std::uint32_t next = 3 * vertices_.partials + pairs_.partials + quadratic_.partials;
    for (const EnergyTerm* term : r.terms) {
      if (!term->acts()) continue;
      const TermCurvature at{fine_direction_, splits_ ? &coarse_direction_ : nullptr, last_step_, partials_, next};
      append(passes, term->curvature(r.programs, r.buffers, at));
      next += term->curvature_partials(r.programs);
      if (const std::optional<PressingRows> rows = term->pressing()) {
        solve.defines = {{"PRESSING_ROWS", "1"}};
        solve.bindings.insert(solve.bindings.end(), {{"contact_along", &rows->along}, {"contact_list", &rows->list}});
        loops += rows->loops;
      }
    }
    const bool quadratic_ends = r.buffers.quadratic_count > 0;
    for (const bool quadratic : {false, true})
      if ((quadratic ? r.buffers.quadratic_count : r.buffers.pair_and_single_count()) > 0)
        append(passes, this->curvature(r, quadratic, curvature_defines, curvature,
                                       last_group_ends(r) && quadratic == quadratic_ends ? &solve : nullptr));
  }
  solve.defines.emplace_back("FINAL", last ? "1" : "0");
  if (!last_group_ends(r))
    passes
        .emplace_back(r.programs.compute("sim/two_level/subspace_solve.comp", solve.defines), solve.bindings, 1,
                      solve.constants)
        .loops(loops);
  if (last || !gradient_moves(r)) passes.push_back(update(r, last));
  return passes;
}

// Where a dispatch costs, on GPUs, the kernels of the next gradient apply the step. Not in contact, whose forces and
// blocks look at the new state before that, nor with displacements of two floats, those of static equilibria.
bool TwoLevelMethod::gradient_moves(const Recording& r) {
  return last_group_ends(r) && !r.has_blocks() && !r.buffers.displacement_low;
}

std::optional<PendingStep> TwoLevelMethod::pending(const Recording& r) const {
  if (!gradient_moves(r)) return {};
  PendingStep step{{{"SPLIT", splits_ ? "1" : "0"}},
                   {{"subspace_state", &state_}, {"fine_direction", &fine_direction_}, {"last_step", &last_step_}},
                   previous_gradient_};
  if (splits_) step.step.emplace_back("coarse_direction", &coarse_direction_);
  return step;
}

gl::ComputePass TwoLevelMethod::update(const Recording& r, bool last) const {
  const bool compensated{r.buffers.displacement_low};
  gl::ComputePass::Bindings bindings{{"subspace_state", &state_},
                                     {"step_before", &last_step_},
                                     {"iterate", &r.buffers.displacement},
                                     {"displacement", &r.buffers.displacement}};
  if (!last) {
    bindings.insert(bindings.end(), {{"fine_direction", &fine_direction_},
                                     {"gradient", &gradient_.gradient()},
                                     {"previous_gradient", &previous_gradient_},
                                     {"last_step", &last_step_}});
    if (splits_) bindings.emplace_back("coarse_direction", &coarse_direction_);
  }
  if (compensated)
    bindings.insert(bindings.end(),
                    {{"iterate_low", &r.buffers.displacement_low}, {"displacement_low", &r.buffers.displacement_low}});
  return r.over_vertices(
      "sim/two_level/subspace_update.comp",
      {{"FINAL", last ? "1" : "0"}, {"SPLIT", splits_ ? "1" : "0"}, {"COMPENSATED", compensated ? "1" : "0"}},
      std::move(bindings));
}

}  // namespace fascia
