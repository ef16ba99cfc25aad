// Runs the solver's recorded passes: plain steps, timed steps and traced ones.
#include "sim/gpu/solver.h"

#include "gl/bindings.h"
#include "sim/gpu/unfolding.h"
#include "sim/model/prescribed_motion.h"

namespace fascia {

void GpuSolver::run(const Passes& passes) {
  for (const gl::ComputePass& pass : passes) {
    pass.run();
    if (timed_) timed_->ran(pass);
  }
}

std::map<std::string, KernelTime> GpuSolver::timed_step() {
  TimedPasses timed;
  timed_ = &timed;
  try {
    step();
  } catch (...) {
    timed_ = nullptr;
    throw;
  }
  timed_ = nullptr;
  return timed.kernels();
}

void GpuSolver::look_beside() {
  method_->complete();
  if (!background_held_) background_taken_ += method_->update(false);
}

std::vector<IntegratorStage> GpuSolver::next_stages() const {
  return stages_of(settings_.integrator, settings_.substep(), earlier_step_);
}

void GpuSolver::upload_step(const IntegratorStage& stage) {
  stage_ = stage;
  buffers_.upload_step(model_, settings_, stage);
}

void GpuSolver::begin_stage(const IntegratorStage& stage) {
  if (stage != stage_) upload_step(stage);
  place_tools(stage);
  time_ += stage.duration;
  ++stages_solved_;
  published_ = false;
  motions_.upload(model_, time_);
  bodies_.begin(stiffness_of(terms_));
  run(kind_->passes.begin, &FusedStep::begin);
}

void GpuSolver::begin_step() {
  step_begin_ = time_;
  step_motion_ = next_tools();
  contact_.begin_step(settings_.substeps);
}

ToolMotion GpuSolver::next_tools() const {
  return led_motion_ ? *led_motion_ : motion_on_paths(given_.tools, time_, time_ + settings_.time_step);
}

void GpuSolver::place_tools(const IntegratorStage& stage) {
  if (!contact_.acts()) return;
  const double from = (time_ - step_begin_) / settings_.time_step;
  stage_motion_ = part_of(given_.tools, {step_motion_, step_begin_, step_begin_ + settings_.time_step}, from,
                          from + stage.duration / settings_.time_step);
  if (!touches()) return;
  contact_.begin_stage(stage_motion_, time_ + stage.duration, stage, buffers_);
}

// What begins to press within the iterations, or leaves what it touched, would be held as at the start of the stage:
// ten iterations under a moving box are 1.4 % off with an update before every fourth iteration, 0.2 % before every
// second, and the same before every one.
bool GpuSolver::takes_contact(int iteration) const {
  constexpr int kInterval = 2;
  return touches() && iteration % kInterval == 0;
}

void GpuSolver::iterate(int iteration, int count) {
  if (takes_contact(iteration)) {
    contact_.read_stiffness(downloads_);
    method_->read_for_contact(downloads_);
    downloads_.run();
    const std::vector<PointStiffness> pressing = contact_.stiffness_at_points();
    method_->set_contact(pressing);
    if (regions_)
      for (const PointStiffness& point : pressing) regions_->press(point.vertices[0]);
  }
  const bool refreshes = StepMethod::refreshes_before(iteration, settings_.iterations);
  if (const FusedStep* fused = fused_step()) {
    if (refreshes) fused->refresh.run();
    if (renews(iteration)) return fused->renew.run();
    if (iteration == 0) return fused->first.run();
    return fused->iteration.run(static_cast<std::uint32_t>(count));
  }
  // With the stiffness of contact that the last forces had, as above; a stop rule looks at the gradient first.
  if (renews(iteration)) {
    if (refreshes) run(kind_->passes.refresh);
    return run(kind_->passes.renew);
  }
  const bool refreshes_first = touches() && !stop_;
  if (refreshes && refreshes_first) run(kind_->passes.refresh);
  if (iteration % before_every_ == 0) run(iteration == 0 ? kind_->passes.before_first : kind_->passes.before);
  if (refreshes && !refreshes_first) run(kind_->passes.refresh);
  run(iteration == 0 ? kind_->passes.first_iteration : kind_->passes.iteration);
}

void GpuSolver::end_stage() { run(kind_->passes.end, &FusedStep::end); }

int GpuSolver::alike_from(int iteration) const {
  int end = iteration + 1;
  while (iteration > 0 && !renews(iteration) && !renews(end) && end < settings_.iterations &&
         !StepMethod::refreshes_before(end, settings_.iterations) && !takes_contact(end))
    ++end;
  return end;
}

const GpuSolver::FusedStep* GpuSolver::fused_step() const { return kind_->fused && !timed_ ? &*kind_->fused : nullptr; }

void GpuSolver::iterate_all() {
  for (int i = 0; i < settings_.iterations;) {
    const int count = fused_step() ? alike_from(i) - i : 1;
    iterate(i, count);
    i += count;
  }
  end_iterations();
}

// Where something is done between the iterations and the end of the stage: takes the last iteration back if it raised
// the objective, and lets bodies that nothing holds go on as wholes.
void GpuSolver::end_iterations() {
  if (kind_->passes.check.empty()) return;
  run(kind_->passes.check, &FusedStep::check);
  if (!is_partial() && !bodies_.empty())
    move_bodies();
  else if (touches())
    contact_.forget_moved_rows();
}

void GpuSolver::move_bodies() {
  if (touches()) return contact_.move_bodies(bodies_, buffers_, downloads_);
  std::vector<shared::vec4> at(buffers_.vertex_count), aim(at.size());
  downloads_.add(buffers_.displacement, at.size() * sizeof(shared::vec4), at.data());
  downloads_.add(buffers_.predicted, aim.size() * sizeof(shared::vec4), aim.data());
  downloads_.run();
  std::vector<Eigen::Vector3d> u = buffers_.vectors_of(at);
  if (bodies_.move(nullptr, buffers_.vectors_of(aim), stage_.length, u)) buffers_.upload_displacements(u, at);
}

void GpuSolver::run(const Passes& passes, gl::FusedPasses FusedStep::*fused) {
  if (const FusedStep* step = fused_step())
    (step->*fused).run();
  else
    run(passes);
}

// The iterations start from where the tissue is, but for stiff bodies that nothing holds: from where these have their
// least objective as wholes. By iterations alone a stiff body that is hit turns late, and is stretched by that: turns
// are far from linear in the displacements that they add. In a soft one a hit stops only what is near.
void GpuSolver::begin_again(bool stiff) {
  if (stiff) move_bodies();
  contact_.stay();
  run(kind_->passes.again, &FusedStep::again);
}

void GpuSolver::solve_stage(const IntegratorStage& stage) {
  begin_stage(stage);
  const bool stiff = !is_partial() && !bodies_.empty() && bodies_.are_stiff(stage.length);
  if (stiff && contact_.meets()) begin_again(stiff);
  iterate_all();
  int searches = 1;
  for (; searches < PairSearch::kMostSearches && contact_.search_again(buffers_); ++searches) {
    run(kind_->passes.relist, &FusedStep::relist);
    begin_again(stiff);
    iterate_all();
  }
  end_stage();
  // Afterwards: bodies that are taken back keep the velocities of the solution, whose forces have led to them.
  if (searches == PairSearch::kMostSearches || contact_.cuts()) contact_.take_back(buffers_);
}

void GpuSolver::solve_substep() {
  for (const IntegratorStage& stage : next_stages()) solve_stage(stage);
  earlier_step_ = info_of(settings_.integrator).multistep ? settings_.substep() : 0;
}

bool GpuSolver::is_near() {
  if (near_) return *near_;
  if (!watch_ || stop_) return true;  // a stop rule governs the passes of one kind of steps
  const double duration = settings_.time_step;
  Eigen::AlignedBox3d led;
  for (const GrabSpring& spring : springs_) led.extend(given_.rest_positions[spring.vertex] + spring.target);
  if (time_ < given_.end_of_motions()) {
    std::vector<Eigen::Vector3d> displacement(given_.rest_positions.size());
    place_prescribed(given_, time_ + duration, displacement);
    for (const Motion& motion : given_.motions)
      for (const std::uint32_t v : motion.vertices) led.extend(given_.rest_positions[v] + displacement[v]);
  }
  return watch_->is_near(given_, {next_tools(), duration, given_.gravity, led});
}

// Forces of contact end with the first step apart.
void GpuSolver::take(StepKind& kind) {
  const bool touched = touches();
  kind_ = &kind;
  if (!kind.passes.recorded()) record(kind);
  if (touched && !touches()) contact_.let_go(buffers_);
  if (!touched && touches()) method_->forget_contact();
}

// Selects the passes with contact or without, for all tets or for the moving part only.
void GpuSolver::choose_passes() {
  const bool after_whole = !is_partial();
  const bool near = !contact_.acts() || is_near(), touching = near && contact_.acts();
  StepKind* kind = near ? &whole_ : &apart_;
  if (regions_) {
    const double way = touching ? contact_.way_of(next_tools()) : 0;
    // What no tool was near when regions were listed stays out of their reach until they have come as far as that.
    const bool reach = way + (is_partial() ? tools_way_ : 0) > contact_.margin();
    if (touching != touches() || reach || time_ < model_.end_of_motions()) regions_->restart();
    tools_way_ += way;
    const auto awake = [&] {
      tools_way_ = way;
      std::vector<std::uint32_t> vertices;
      if (touching) vertices = contact_.near_vertices();
      for (const VertexStiffness& spring : stiffness_of(terms_)) vertices.push_back(spring.vertex);
      return vertices;
    };
    if (regions_->begin_step(settings_, awake)) kind = near ? &partial_ : &partial_apart_;
  }
  take(*kind);
  if (is_partial() && after_whole) {
    // Vertices beside resting tets would add stale values in the slots of those, from an earlier step, a heat map or
    // diagnostics, to the objective.
    buffers_.correction.clear();
    method_->begin_partial();
  }
  work_done_ += is_partial() ? regions_->active().work : buffers_.work();
}

void GpuSolver::run_partial_kernels() {
  if (!regions_) return;
  StepKind& before = *kind_;
  std::vector<StepKind*> kinds{&partial_};
  if (contact_.acts()) kinds.push_back(&partial_apart_);
  const State state = download();
  for (StepKind* kind : kinds) {
    take(*kind);
    method_->begin_partial();
    solve_substep();
  }
  take(before);
  if (contact_.acts()) buffers_.upload_state(model_, state);
  time_ = state.time;
  restart_rounds();
}

void GpuSolver::run_contact_kernels() {
  if (!watch_) return;
  near_ = !touches();
  step();
  near_.reset();
}

void GpuSolver::unfold() {
  if (starts_inside_out_) {
    starts_inside_out_ = false;
    unfolding_ = Unfolding{time_ + kLongestUnfolding};
    materials_changed();
  } else if (++unfolding_->steps % kUnfoldingInterval == 0 &&
             (time_ >= unfolding_->until || is_unfolded(given_, download()))) {
    end_unfolding();
  }
}

void GpuSolver::end_unfolding() {
  unfolding_.reset();
  materials_changed();
}

bool GpuSolver::handled() const { return !springs_.empty() || touches() || time_ < given_.end_of_motions(); }

void GpuSolver::set_hardness(Hardness hardness) {
  if (hardness == buffers_.hardness) return;
  buffers_.hardness = hardness;
  buffers_.upload_materials(model_);
  upload_step(next_stages().front());
}

void GpuSolver::step() {
  const gl::KeptBindings kept;
  if (starts_inside_out_ || unfolding_) unfold();
  if (tangles_ && !buffers_.displacement_low) set_hardness(tangles_->hardness(time_, handled()));
  look_beside();
  choose_passes();
  begin_step();
  for (int s = 0; s < settings_.substeps; ++s) solve_substep();
  if (regions_) regions_->end_step();
  has_step_ = true;
  ++steps_solved_;
}

void GpuSolver::settle(const State& equilibrium) {
  upload(equilibrium);
  step();
  buffers_.upload_state(model_, equilibrium);
  time_ = equilibrium.time;
  earlier_step_ = 0;
  published_ = false;
  guard_.keep(buffers_, {time_});
}

void GpuSolver::rest() {
  time_ += settings_.time_step;
  earlier_step_ = 0;
  guard_.pass_time(settings_.time_step);
}

std::vector<Diagnostics> GpuSolver::traced_substep() {
  std::vector<Diagnostics> trace;
  const auto diagnose = [&] {
    request_diagnostics();
    trace.push_back(*take_diagnostics(true));
  };
  take(!contact_.acts() || is_near() ? whole_ : apart_);
  if (regions_) regions_->restart();
  look_beside();
  begin_step();
  const std::vector<IntegratorStage> stages = next_stages();
  for (std::size_t k = 0; k + 1 < stages.size(); ++k) solve_stage(stages[k]);
  begin_stage(stages.back());
  if (grab_.acts()) grab_.forget();
  diagnose();
  for (int i = 0; i < settings_.iterations; ++i) {
    iterate(i);
    run(kind_->passes.completion);
    diagnose();
  }
  end_iterations();
  end_stage();
  earlier_step_ = 0;
  return trace;
}

}  // namespace fascia
