#include "sim/gpu/solver.h"

#include <tuple>

#include "base/error.h"
#include "sim/contact/first_state.h"
#include "sim/gpu/methods/methods.h"
#include "sim/gpu/passes/compute_probe.h"
#include "sim/gpu/unfolding.h"

namespace fascia {
namespace {

// The model. Throws Error if the method has no kernels for its elements or for contact.
const Model& with_elements_of(Method method, const Model& model) {
  if (model.has_contact() && !info_of(method).carries_contact)
    throw Error("solver.method", std::string(name_of(method)) + " does not carry contact",
                "expected two_level, or a scene without contact");
  if (model.has_quadratic() && !info_of(method).carries_quadratic)
    throw Error("solver.method", std::string(name_of(method)) + " does not carry quadratic elements",
                "expected two_level, or bodies with linear elements");
  return model;
}

}  // namespace

GpuSolver::GpuSolver(gl::ProgramCache& programs, const Model& model, const SolverSettings& settings,
                     const EmbeddedPoints& drawn, const Progress& progress)
    : GpuSolver(programs, model, settings, drawn, progress, mesh_order_of(with_elements_of(settings.method, model))) {}

GpuSolver::GpuSolver(gl::ProgramCache& programs, const Model& model, const SolverSettings& settings,
                     const EmbeddedPoints& drawn, const Progress& progress, MeshOrder placement)
    : programs_(programs),
      given_(model),
      model_(placed(model, placement)),
      settings_(settings),
      parts_(unconstrained_parts(model_, model_.held())),
      features_(features_of(model)),
      buffers_(model_, std::move(placement)),
      motions_(model_),
      contact_(given_, buffers_, programs.load_path()),
      bodies_(given_, buffers_),
      diagnostics_(buffers_),
      guard_(programs, buffers_),
      surface_(buffers_, drawn) {
  if (!model_.tools.empty() && !contact_.searches()) watch_.emplace(programs, buffers_);
  require_carried(settings_.method, model.materials, "solver.method");
  require_computing(programs);
  upload_step(next_stages().front());
  reset();
  report(progress, 0.4, "Preparing the solver");
  make_method();
  report(progress, 0.9, "Compiling kernels");
  record();
}

void GpuSolver::make_method() {
  tangles_.reset();  // the order of the tets may change
  const MethodKernels& kernels = kernels_of(settings_.method);
  const MethodInputs inputs{programs_, model_, buffers_, settings_};
  regions_.reset();
  if (!method_ || made_ != settings_.method || !method_->goes_on_with(inputs)) {
    method_.reset();  // before the next one is created: memory may not suffice for both
    // The condition is not the previous method: one that ran out of memory may have left its order.
    if (!kernels.orders_tets && buffers_.pair_count == 0) {
      buffers_.set_tet_order(model_, buffers_.placement.tets);
      buffers_.set_phantom_count(0);
    }
    method_ = kernels.make(inputs);
    made_ = settings_.method;
  }
  stop_.reset();
  if (settings_.tolerance > 0) stop_.emplace(programs_, buffers_, method_->gradient());
  stages_solved_ = 0;
  grab_.set_use(method_->descends(), method_->descends() || stop_, buffers_.vertex_count);
  method_->set_stiffness(stiffness_of(terms_));

  acceleration_.reset();
  multiplier_weight_ = {};
  AccelerationInputs accelerated{programs_, buffers_, settings_, {}};
  if (settings_.acceleration == Acceleration::anderson && !method_->accelerates_itself()) {
    accelerated.state.push_back(
        {&buffers_.displacement, buffers_.vertex_count, &method_->weight_of_vertices(buffers_)});
    if (method_->multiplier()) {
      multiplier_weight_ = gl::Buffer("multiplier_weight", 2 * sizeof(float) * buffers_.tet_count);
      accelerated.state.push_back({method_->multiplier(), 2 * buffers_.tet_count, &multiplier_weight_});
    }
  }
  acceleration_ = make_acceleration(accelerated);
}

void GpuSolver::reset() { upload(first_state(given_)); }

void GpuSolver::upload(const State& state) {
  buffers_.upload_state(model_, state);
  time_ = state.time;
  starts_inside_out_ = needs_unfolding(given_, state);
  if (unfolding_ && !starts_inside_out_) end_unfolding();
  state_changed();
  set_hardness(Hardness::own);
  if (buffers_.earlier_displacement) earlier_step_ = state.earlier.step;
  guard_.keep(buffers_, {time_, earlier_step_});
}

void GpuSolver::restore_valid(bool at_rest) {
  const StateGuard::Moment moment = guard_.restore(buffers_);
  state_changed();
  time_ = moment.time;
  if (at_rest)
    buffers_.velocity.upload(0, buffers_.velocity.bytes(), std::vector<shared::vec4>(buffers_.vertex_count).data());
  else
    earlier_step_ = moment.earlier_step;
}

void GpuSolver::state_changed() {
  has_step_ = false;
  published_ = false;
  earlier_step_ = 0;
  restart_rounds();
  if (tangles_) tangles_->restart();
  if (method_) method_->forget_contact();
  buffers_.forget_multipliers();
  contact_.forget_forces();
}

void GpuSolver::restart_rounds() {
  if (regions_) regions_->restart();
  if (watch_) watch_->restart();
}

void GpuSolver::request_check() {
  guard_.request(buffers_, {time_, earlier_step_});
  // So that steps from this state on are repeated to the bit
  restart_rounds();
  method_->forget_contact();
}

std::optional<StateGuard::Verdict> GpuSolver::take_check(bool wait) {
  std::optional<StateGuard::Verdict> verdict = guard_.take(wait);
  if (verdict && verdict->diverged) verdict->diverged = vertex_at(*verdict->diverged);
  return verdict;
}

std::optional<std::uint32_t> GpuSolver::diverged_now() const {
  const std::uint32_t place = buffers_.diverged.read<std::uint32_t>().front();
  return place == ~0u ? std::nullopt : std::optional(vertex_at(place));
}

std::uint32_t GpuSolver::vertex_at(std::uint32_t place) const {
  if (place >= buffers_.vertex_count)
    throw Error(gl::device().renderer, "the number of a diverged vertex was read back as " + std::to_string(place),
                "expected one below " + std::to_string(buffers_.vertex_count));
  return buffers_.placement.vertex[place];
}

void GpuSolver::set_probe(std::optional<std::uint32_t> vertex) {
  if (vertex) vertex = buffers_.placement.place[*vertex];
  diagnostics_.set_probe(vertex);
}

void GpuSolver::solve_everything() {
  always_whole_ = true;
  record();
}

void GpuSolver::set_settings(const SolverSettings& settings) {
  require_carried(settings.method, given_.materials, "solver.method");
  with_elements_of(settings.method, given_);
  const auto needs = [](const SolverSettings& s) {
    return std::tuple(s.method, s.acceleration, s.integrator, s.colors, s.window, s.tolerance > 0, s.rest_speed > 0);
  };
  const bool same_passes = needs(settings) == needs(settings_);
  SolverSettings before = settings_;
  before.iterations = settings.iterations;
  // Ignores the number of iterations, which a frame budget changes constantly
  const bool same_step = before == settings;
  before = settings_;
  settings_ = settings;
  if (same_step) {
    upload_step(stage_);
    return;
  }
  if (!same_passes) try {
      make_method();
      record();
    } catch (...) {  // not enough memory
      settings_ = before;
      make_method();
      record();
      throw;
    }
  settings_changed();
}

void GpuSolver::settings_changed() {
  has_step_ = false;
  published_ = false;
  restart_rounds();
  upload_step(next_stages().front());
  method_->values_changed(model_, settings_);
  if (acceleration_) acceleration_->values_changed();
}

void GpuSolver::materials_changed() {
  ++materials_version_;
  model_.materials = given_.materials;
  if (unfolding_) take_unfolding_law(model_.materials);
  model_.gravity = given_.gravity;
  buffers_.upload_materials(model_);
  contact_.materials_changed(given_, buffers_);
  bodies_.materials_changed();
  settings_changed();
  if (const Features features = features_of(model_); features != features_ || may_relax() != relaxes_) {
    features_ = features;
    record();
  }
}

void GpuSolver::set_grab(const std::vector<GrabSpring>& springs) {
  springs_ = springs;
  has_step_ = false;
  std::vector<GrabSpring> placed_springs = springs;
  for (GrabSpring& spring : placed_springs) spring.vertex = buffers_.placement.place[spring.vertex];
  const bool others = grab_.set(placed_springs);
  method_->set_stiffness(stiffness_of(terms_));
  if (!others) return;
  record();
  restart_rounds();
}

void GpuSolver::set_color(ColorBy color) {
  if (color == color_) return;
  color_ = color;
  surface_.record(programs_, buffers_, features_, color_, contact_);
  published_ = false;
}

void GpuSolver::set_vertex_errors(const std::vector<float>& errors) {
  surface_.set_vertex_errors(errors);
  published_ = false;
}

void GpuSolver::publish() {
  if (!published_) surface_.run();
  published_ = true;
}

void GpuSolver::follow(const GpuSolver& leader) {
  if (materials_version_ != leader.materials_version_) {
    materials_changed();
    materials_version_ = leader.materials_version_;
  }
  set_grab(leader.springs_);
  buffers_.displacement.copy(leader.buffers_.displacement, buffers_.vertex_count * sizeof(shared::vec4));
  buffers_.velocity.copy(leader.buffers_.velocity, buffers_.velocity.bytes());
  if (buffers_.contact_memory)
    buffers_.contact_memory.copy(leader.buffers_.contact_memory, buffers_.contact_memory.bytes());
  led_motion_ = leader.led_motion_;
  if (led_motion_) led_motion_->from = led_motion_->to;
  time_ = leader.time_;
  state_changed();
  if (tangles_ && leader.tangles_) tangles_->follow(*leader.tangles_);
  if (leader.earlier_step_ == 0 || !buffers_.earlier_displacement) return;
  earlier_step_ = leader.earlier_step_;
  buffers_.earlier_displacement.copy(leader.buffers_.earlier_displacement, buffers_.earlier_displacement.bytes());
  buffers_.earlier_velocity.copy(leader.buffers_.earlier_velocity, buffers_.earlier_velocity.bytes());
}

void GpuSolver::request_diagnostics() {
  diagnostics_.request(grab_, contact_, stage_.length, time_, stop_ ? &stop_->state() : nullptr, has_step_);
}

State GpuSolver::download() const {
  State state = buffers_.download_state(time_, earlier_step_);
  if (buffers_.has_quadratic() && has_step_)
    state.acceleration = buffers_.download_accelerations(model_.gravity, stage_.length);
  return state;
}

void GpuSolver::set_compensated(bool compensated) {
  const State state = download();
  buffers_.displacement_low =
      compensated ? gl::Buffer("displacement_low", sizeof(shared::vec4) * buffers_.vertex_count) : gl::Buffer();
  upload(state);
  record();
}

}  // namespace fascia
