#include "sim/simulation/simulation.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <tuple>

#include "base/error.h"
#include "base/file.h"
#include "sim/contact/contact_surface.h"
#include "sim/contact/first_state.h"
#include "sim/contact/pair_search.h"
#include "sim/grab/build_model.h"
#include "sim/model/region_materials.h"

namespace fascia {
namespace {

void require_able(const SolverSettings& solver, const Model& model, const std::string& file) {
  const MethodInfo& method = info_of(solver.method);
  const auto refuse = [&](const char* what, const std::string& expected) {
    throw Error(file + ": solver.method", std::string(method.name) + " does not carry " + what,
                "expected two_level, or " + expected);
  };
  if (model.has_contact() && !method.carries_contact)
    refuse("contact",
           "a scene without contact: without the keys ground, obstacles and instruments, and with "
           "contact.bodies and contact.self false");
  if (model.has_quadratic() && !method.carries_quadratic) refuse("quadratic elements", "bodies with linear elements");
}

// For solvers that are made anew with the materials of `after`.
void soften_contact(ContactMemory& memory, const Model& before, const Model& after) {
  if (memory.empty()) return;
  const ContactSurface surface = make_contact_surface(before);
  PairSearch pairs(before);
  if (memory.size() != surface.row_count + pairs.row_count()) return;
  soften(memory, surface, contact_stiffness(before, surface), contact_stiffness(after, surface));
  pairs.materials_changed(after, std::span(memory).subspan(surface.row_count));
}

}  // namespace

Simulation::Simulation(Scene opened, gl::ProgramCache* programs, bool use_reference)
    : Simulation(opened, build_model(opened), programs, use_reference) {}

Simulation::Simulation(Scene opened, Model built, gl::ProgramCache* programs, bool use_reference,
                       const Progress& progress)
    : scene(std::move(opened)), model(std::move(built)), programs_(programs) {
  if (programs) require_able(scene.solver, model, scene.file.string());
  if (programs) gpu_ = std::make_unique<GpuSolver>(*programs, model, scene.solver, model.embedded, progress);
  if (use_reference) {
    renew_reference();
    reference_state_ = first_state(model);
  }
  begin_anew();
}

void Simulation::step() {
  if (!asleep_) leave_equilibrium();
  repeat_inputs();
  simulated_ += scene.solver.time_step;
  make_step();
  if (!replaying()) repeat_inputs();  // a session may end with a reset
}

void Simulation::make_step() {
  const bool replaying_timed = replaying() && replay_->timed;  // uses the recorded number of iterations
  pull(with_grabs(other_springs_, model.grabs, time() + scene.solver.time_step));
  if (asleep_ && tools_disturb()) wake();
  tools_moved_ = tools_move();
  give_motion();
  led_.arrive();
  ++steps_;
  if (!reference_) {
    if (asleep_) {
      gpu_->rest();
      if (equilibrium_) equilibrium_->time = gpu_->time();
      ++steps_asleep_;
      return;
    }
    if (scene.solver.frame_budget > 0 && !replaying_timed)
      step_within_budget();
    else
      gpu_->step();
    tell_of_background(steps_ - 1);
    follow_check(false);
    if (!diverged_ && steps_ - checked_step_ >= kCheckInterval) look();
    return;
  }
  newton_report_ = reference_->step(reference_state_);
  newton_taken_back_ += newton_report_.taken_back;
  if (gpu_) gpu_->upload(reference_state_);
}

ToolMotion Simulation::tool_motion() const { return led_.motion(model.tools, time(), time() + scene.solver.time_step); }

bool Simulation::tools_move() const {
  if (model.tools.empty()) return false;
  const ToolMotion motion = tool_motion();
  return motion.from != motion.to;
}

// Whether a tool moves in the next step where it may touch tissue that has come to rest.
bool Simulation::tools_disturb() {
  if (!tools_move()) return false;
  const ToolMotion motion = tool_motion();
  if (!asleep_) cover_tissue();
  for (std::size_t t = 0; t < model.tools.size(); ++t)
    if (cover_->is_met_by(model.tools[t], motion.from[t], motion.to[t])) return true;
  return false;
}

void Simulation::cover_tissue() {
  if (model.tools.empty()) return;
  constexpr double kBall = 0.02;  // of the scene's size, as far as tools are looked for
  if (!cover_) cover_.emplace(model, kBall * gpu_->buffers().size);
  std::vector<Eigen::Vector3d> positions = state().displacement;
  for (std::size_t v = 0; v < positions.size(); ++v) positions[v] += model.rest_positions[v];
  cover_->follow(positions);
}

void Simulation::give_motion() {
  const std::optional<ToolMotion> motion = led_.empty() ? std::nullopt : std::optional(tool_motion());
  if (reference_)
    reference_->set_tools(motion);
  else
    gpu_->set_tools(motion);
}

std::vector<ToolPlace> Simulation::tool_places() const { return led_.motion(model.tools, time(), time()).to; }

void Simulation::lead(const LedTool& tool) {
  const std::vector<LedTool> led = led_.tools();
  if (std::find(led.begin(), led.end(), tool) != led.end()) return;
  led_.lead(tool);
  log_.add({steps_, tool});
  tell(tool);
}

void Simulation::wake() {
  if (asleep_) {  // steps before this one need no repetition
    checked_step_ = steps_;
    log_.forget_before(steps_);
  }
  woken_step_ = steps_;
  asleep_ = quiet_ = false;
  rest_.restart();
  settling_.cancel();
  settles_after_ = 0;
}

void Simulation::renew_reference() {
  reference_ = std::make_unique<reference::NewtonSolver>(model, scene.solver, interrupt_token());
  reference_->set_springs(springs_);
}

void Simulation::leave_equilibrium() {
  equilibrium_.reset();
  equilibrium_contact_.reset();
}

void Simulation::correct_contact(std::optional<Diagnostics>& of_gpu) const {
  if (!equilibrium_contact_ || !of_gpu) return;
  of_gpu->set_loads(equilibrium_contact_->loads, equilibrium_contact_->loads);
  of_gpu->reaction = reference::measure(model, state(), equilibrium_contact_->vertices).fixed_reaction;
}

std::vector<Eigen::Vector3d> Simulation::contact_forces() const {
  if (reference_) return reference_->contact_forces();
  return equilibrium_contact_ ? equilibrium_contact_->vertices : gpu_->contact_forces();
}

void Simulation::back_to_valid() {
  leave_equilibrium();
  gpu_->restore_valid(false);
  valid_state_ = gpu_->download();
  valid_state_.led = led_.tools();
  gpu_->restore_valid(true);
  diverged_.reset();
  tell(RestoreInput{});
}

Tuning Simulation::tuning() const {
  Tuning now{scene.solver, model.materials, model.gravity, other_springs_, led_.tools()};
  now.solver.frame_budget = 0;  // the iterations that fitted are recorded as inputs
  return now;
}

void Simulation::begin_anew() {
  wake();
  checked_step_ = steps_;
  log_.restart(steps_, tuning());
}

void Simulation::step_within_budget() {
  const SolverSettings& wanted = scene.solver;
  int iterations = wanted.iterations;
  if (ms_per_iteration_ > 0)
    iterations = static_cast<int>(std::clamp<double>(
        std::floor(wanted.frame_budget / (ms_per_iteration_ * wanted.stages_per_step())), 1, iterations));
  if (iterations != gpu_->settings().iterations) {
    --steps_;  // inputs apply before this step
    grant(iterations);
    ++steps_;
  }
  gl::Finish();  // earlier queued work is not part of the step
  const auto start = std::chrono::steady_clock::now();
  gpu_->step();
  gl::Finish();
  const double ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  const double per_iteration = ms / (std::max(gpu_->last_iterations(), 1) * wanted.stages_per_step());
  constexpr double kNews = 0.2;  // weight of a new measurement: a slow step must not affect many others
  ms_per_iteration_ = ms_per_iteration_ > 0 ? (1 - kNews) * ms_per_iteration_ + kNews * per_iteration : per_iteration;
}

void Simulation::grant(int iterations) {
  SolverSettings fitting = scene.solver;
  fitting.iterations = iterations;
  if (gpu_) gpu_->set_settings(fitting);
  fitting.frame_budget = 0;
  log_.add({steps_, fitting});
  tell(GrantInput{iterations});
}

void Simulation::go_on_from(const State& state) {
  if (state.displacement.size() != model.rest_positions.size())
    throw Error(scene.file.string(), "start has " + std::to_string(state.displacement.size()) + " vertices",
                "expected the mesh's " + std::to_string(model.rest_positions.size()));
  leave_equilibrium();
  if (reference_) {
    reference_state_ = state;
    reference_state_.acceleration.clear();  // as on the GPU: what was set need not be the end of a step
    reference_state_.taken_back = false;
  }
  if (gpu_) gpu_->upload(state);
  led_.restart(state.led);
  diverged_.reset();
  begin_anew();
}

State Simulation::go_on_as_replay() {
  const State now = state();
  set_settings(scene.solver);  // all iterations, regardless of the last number granted
  if (gpu_) {
    gpu_->materials_changed();
    gpu_->finish_background();
    gpu_->background_taken();
  }
  go_on_from(now);
  return now;
}

double Simulation::time() const { return reference_ ? reference_state_.time : gpu_->time(); }

void Simulation::set_settings(const SolverSettings& settings) {
  require_carried(settings.method, model.materials, "solver.method");
  if (gpu_) gpu_->set_settings(settings);  // first, because it may run out of memory
  if (settings.choice() != scene.solver.choice()) ms_per_iteration_ = 0;
  scene.solver = settings;
  SolverSettings logged = settings;
  logged.frame_budget = 0;
  wake();
  log_.add({steps_, logged});
  tell(settings);
  if (reference_) renew_reference();
}

void Simulation::set_material(std::size_t index, const Material& material) {
  require_carried(scene.solver.method, {material}, "material.model");
  Material repainted = model.materials[index];
  repainted.look = material.look;
  repainted.color = material.color;
  const bool only_looks = repainted == material;  // differently: nothing moves
  if (!only_looks) wake();
  log_.add({steps_, MaterialInput{index, material}});
  const std::optional<Model> before = reference_ ? std::optional(model) : std::nullopt;
  model.materials[index] = material;
  tell(MaterialInput{index, material});
  if (only_looks) return;
  if (gpu_) gpu_->materials_changed();
  if (!reference_) return;
  soften_contact(reference_state_.contact, *before, model);
  renew_reference();
}

void Simulation::set_material_entries(const std::vector<MaterialEntries>& entries) {
  Scene changed = scene;
  for (std::size_t b = 0; b < entries.size(); ++b) {
    changed.bodies[b].material = entries[b].material;
    changed.bodies[b].region_materials = entries[b].region_materials;
  }
  Model other = model;
  assign_materials(changed, other);
  require_carried(scene.solver.method, other.materials, "materials");
  const auto regions = [](const Model& m) { return std::tie(m.tet_material, m.material_names); };
  if (regions(other) == regions(model)) {  // only values or empty entries changed: every solver continues
    scene = std::move(changed);
    for (std::size_t i = 0; i < other.materials.size(); ++i)
      if (other.materials[i] != model.materials[i]) set_material(i, other.materials[i]);
    return;
  }
  State now = state();
  std::swap(model, other);  // the new solver reads it there
  soften_contact(now.contact, other, model);
  if (reference_) reference_state_.contact = now.contact;
  try {
    if (gpu_) {
      auto renewed = std::make_unique<GpuSolver>(*programs_, model, gpu_->settings(), model.embedded);
      renewed->upload(now);
      renewed->set_color(gpu_->color());
      renewed->set_grab(gpu_->springs());
      gpu_ = std::move(renewed);
    }
  } catch (...) {  // not enough memory
    std::swap(model, other);
    throw;
  }
  scene = std::move(changed);
  replay_.reset();
  if (reference_) renew_reference();
  begin_anew();
}

void Simulation::set_gravity(const Eigen::Vector3d& gravity) {
  wake();
  log_.add({steps_, GravityInput{gravity}});
  tell(GravityInput{gravity});
  scene.gravity = model.gravity = gravity;
  if (gpu_) gpu_->materials_changed();
  if (reference_) renew_reference();
}

void Simulation::set_grab(std::vector<GrabSpring> springs) {
  const std::optional<GrabMove> move = held_.follow(springs);
  if (springs == other_springs_) return;  // an unchanged grab wakes no region
  if (!move) held_.restart(springs);
  if (move)
    apply_grab(springs, *move);
  else
    apply_grab(springs, springs);
}

void Simulation::apply_grab(const std::vector<GrabSpring>& springs, Change change) {
  wake();
  log_.add({steps_, springs});
  tell(std::move(change));
  other_springs_ = springs;
  pull(with_grabs(springs, model.grabs, time() + scene.solver.time_step));
}

// Grabs of the scene are not recorded as inputs: a replay has them in its scene.
void Simulation::pull(std::vector<GrabSpring> springs) {
  if (springs == springs_) return;
  wake();
  springs_ = std::move(springs);
  if (gpu_) gpu_->set_grab(springs_);
  if (reference_) reference_->set_springs(springs_);
}

State Simulation::state() const {
  State state = reference_ ? reference_state_ : equilibrium_ ? *equilibrium_ : gpu_->download();
  state.led = led_.tools();
  return state;
}

State Simulation::last_valid() const {
  State state = gpu_->download_valid();
  state.led = led_.tools();
  return state;
}

double Simulation::mean_iterations() const {
  return gpu_ && !reference_ ? gpu_->mean_iterations() : scene.solver.iterations;
}

}  // namespace fascia
