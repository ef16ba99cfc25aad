#include "sim/gpu/solver.h"

#include <iterator>
#include <numeric>
#include <tuple>

namespace fascia {
namespace {

void run(const std::vector<gl::ComputePass>& passes) {
  for (const gl::ComputePass& pass : passes) pass.run();
}

}  // namespace

gl::ComputePass prediction(gl::ProgramCache& programs, const SimBuffers& buffers, const gl::Buffer* copy_begin) {
  gl::ComputePass::Bindings bindings{{"step", &buffers.step},
                                     {"rest_position", &buffers.rest_position},
                                     {"velocity", &buffers.velocity},
                                     {"displacement", &buffers.displacement},
                                     {"previous_displacement", &buffers.previous_displacement},
                                     {"predicted", &buffers.predicted}};
  if (copy_begin) bindings.emplace_back("copy_begin", copy_begin);
  return {programs.compute("sim/predict.comp", {{"MASS_SPLITTING", copy_begin ? "1" : "0"}}), std::move(bindings),
          buffers.vertex_count};
}

GpuSolver::GpuSolver(gl::ProgramCache& programs, const Model& model, const SolverSettings& settings,
                     const std::vector<Eigen::Vector3d>& surface_points)
    : programs_(programs),
      model_(model),
      settings_(settings),
      features_(features_of(model)),
      buffers_(model),
      motions_(model),
      diagnostics_(buffers_),
      surface_(buffers_, surface_points, embed(surface_points, model.rest_positions, model.tets)) {
  buffers_.upload_step(model_, settings_);
  make_method();
  record();
}

void GpuSolver::make_method() {
  if (settings_.method == Method::gauss_seidel) {
    jacobi_.reset();
    if (!gauss_seidel_ || gauss_seidel_->colors_asked() != settings_.colors) {
      gauss_seidel_.reset();
      gauss_seidel_.emplace(model_, buffers_, settings_.colors);
    }
  } else {
    if (gauss_seidel_) {
      gauss_seidel_.reset();
      std::vector<std::uint32_t> file_order(buffers_.tet_count);
      std::iota(file_order.begin(), file_order.end(), 0u);
      buffers_.set_tet_order(model_, file_order);
      buffers_.set_phantom_count(0);
    }
    if (!jacobi_) jacobi_.emplace(buffers_.tet_count);
  }
  chebyshev_.reset();
  anderson_positions_.reset();
  if (settings_.acceleration == Acceleration::chebyshev) chebyshev_.emplace(programs_, buffers_.vertex_count);
  if (settings_.acceleration == Acceleration::anderson_positions)
    anderson_positions_.emplace(programs_, buffers_.vertex_count, settings_.window);
}

void GpuSolver::record() {
  if (features_.damping && !previous_strain_)
    previous_strain_ = gl::Buffer("previous_strain", 2 * sizeof(shared::vec4) * buffers_.tet_count);
  begin_.clear();
  const gl::Buffer* copy_begin = gauss_seidel_                                 ? gauss_seidel_->copy_begin()
                                 : settings_.method == Method::mass_splitting ? &buffers_.slot_begin
                                                                              : nullptr;
  begin_.push_back(prediction(programs_, buffers_, copy_begin));
  if (!motions_.empty()) begin_.push_back(motions_.pass(programs_, buffers_));
  if (features_.damping)
    begin_.emplace_back(programs_.compute("sim/previous_strain.comp"),
                        gl::ComputePass::Bindings{{"tet_vertices", &buffers_.tet_vertices},
                                                  {"tet_shape", &buffers_.tet_shape},
                                                  {"previous_displacement", &buffers_.previous_displacement},
                                                  {"previous_strain", &previous_strain_}},
                        buffers_.tet_count);
  first_iteration_ = iteration(true);
  iteration_ = iteration(false);
  end_.clear();
  end_.emplace_back(programs_.compute("sim/velocity.comp"),
                    gl::ComputePass::Bindings{{"step", &buffers_.step},
                                              {"displacement", &buffers_.displacement},
                                              {"previous_displacement", &buffers_.previous_displacement},
                                              {"velocity", &buffers_.velocity}},
                    buffers_.vertex_count);
  diagnostics_.record(programs_, buffers_, features_, previous_strain_, grab_);
  surface_.record(programs_, buffers_, features_, color_);
}

std::vector<gl::ComputePass> GpuSolver::iteration(bool first) const {
  std::vector<gl::ComputePass> passes = jacobi_ ? jacobi_->iteration(programs_, buffers_, features_, previous_strain_, first)
                                                : gauss_seidel_->iteration(programs_, buffers_, features_, previous_strain_, first);
  if (!grab_.empty()) passes.push_back(grab_.pull(programs_, buffers_, first));
  // The prediction is where the iterations start.
  std::vector<gl::ComputePass> accelerate;
  if (chebyshev_) accelerate = chebyshev_->passes(programs_, buffers_.step, buffers_.predicted, buffers_.displacement, first);
  if (anderson_positions_)
    accelerate = anderson_positions_->passes(programs_, buffers_.predicted, buffers_.displacement, first);
  std::move(accelerate.begin(), accelerate.end(), std::back_inserter(passes));
  return passes;
}

void GpuSolver::begin_substep() {
  time_ += settings_.substep();
  motions_.upload(model_, time_);
  run(begin_);
}

void GpuSolver::step() {
  for (int s = 0; s < settings_.substeps; ++s) {
    begin_substep();
    run(first_iteration_);
    for (int i = 1; i < settings_.iterations; ++i) run(iteration_);
    run(end_);
  }
}

std::vector<Diagnostics> GpuSolver::traced_substep() {
  std::vector<Diagnostics> trace;
  const auto diagnose = [&] {
    request_diagnostics();
    trace.push_back(*take_diagnostics(true));
  };
  begin_substep();
  if (!grab_.empty()) grab_.forget();
  diagnose();
  for (int i = 0; i < settings_.iterations; ++i) {
    run(i == 0 ? first_iteration_ : iteration_);
    diagnose();
  }
  run(end_);
  return trace;
}

void GpuSolver::reset() { upload(reference::initial_state(model_)); }

void GpuSolver::upload(const reference::State& state) {
  buffers_.upload_state(model_, state);
  time_ = state.time;
}

void GpuSolver::set_settings(const SolverSettings& settings) {
  const auto needs = [](const SolverSettings& s) { return std::tuple(s.method, s.acceleration, s.colors, s.window); };
  const bool same_passes = needs(settings) == needs(settings_);
  settings_ = settings;
  if (!same_passes) {
    make_method();
    record();
  }
  settings_changed();
}

void GpuSolver::settings_changed() {
  buffers_.upload_step(model_, settings_);
  if (chebyshev_) chebyshev_->forget_spectral_radius();
}

void GpuSolver::materials_changed() {
  settings_changed();
  buffers_.upload_materials(model_);
  if (const Features features = features_of(model_); features != features_) {
    features_ = features;
    record();
  }
}

void GpuSolver::set_grab(const std::vector<GrabSpring>& springs) {
  springs_ = springs;
  if (grab_.set(springs)) record();
}

void GpuSolver::set_color(ColorBy color) {
  if (color == color_) return;
  color_ = color;
  surface_.record(programs_, buffers_, features_, color_);
}

void GpuSolver::follow(const GpuSolver& leader) {
  materials_changed();
  set_grab(leader.springs_);
  buffers_.displacement.copy(leader.buffers_.displacement, buffers_.vertex_count * sizeof(shared::vec4));
  buffers_.velocity.copy(leader.buffers_.velocity, buffers_.velocity.bytes());
  time_ = leader.time_;
}

void GpuSolver::request_diagnostics() { diagnostics_.request(grab_, settings_.substep()); }

std::uint64_t GpuSolver::dispatches_per_step() const {
  const std::uint64_t iterations = first_iteration_.size() + (settings_.iterations - 1) * iteration_.size();
  return settings_.substeps * (begin_.size() + iterations + end_.size());
}

}  // namespace fascia
