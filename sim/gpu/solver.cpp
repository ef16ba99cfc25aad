#include "sim/gpu/solver.h"

namespace fascia {
namespace {

void run(const std::vector<gl::ComputePass>& passes) {
  for (const gl::ComputePass& pass : passes) pass.run();
}

}  // namespace

gl::ComputePass prediction(gl::ProgramCache& programs, const SimBuffers& buffers, bool split_masses) {
  gl::ComputePass::Bindings bindings{{"step", &buffers.step},
                                     {"rest_position", &buffers.rest_position},
                                     {"velocity", &buffers.velocity},
                                     {"displacement", &buffers.displacement},
                                     {"previous_displacement", &buffers.previous_displacement},
                                     {"predicted", &buffers.predicted}};
  if (split_masses) bindings.emplace_back("slot_begin", &buffers.slot_begin);
  return {programs.compute("sim/predict.comp", {{"MASS_SPLITTING", split_masses ? "1" : "0"}}), std::move(bindings),
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
  buffers_.upload_step(model_, settings_.substep());
  record();
}

void GpuSolver::record() {
  if (features_.damping && !previous_strain_)
    previous_strain_ = gl::Buffer("previous_strain", 2 * sizeof(shared::vec4) * buffers_.tet_count);
  begin_.clear();
  begin_.push_back(prediction(programs_, buffers_, settings_.method == Method::mass_splitting));
  if (!motions_.empty()) begin_.push_back(motions_.pass(programs_, buffers_));
  if (features_.damping)
    begin_.emplace_back(programs_.compute("sim/previous_strain.comp"),
                        gl::ComputePass::Bindings{{"tet_vertices", &buffers_.tet_vertices},
                                                  {"tet_shape", &buffers_.tet_shape},
                                                  {"previous_displacement", &buffers_.previous_displacement},
                                                  {"previous_strain", &previous_strain_}},
                        buffers_.tet_count);
  if (settings_.method == Method::gauss_seidel) {
    jacobi_.reset();
    if (!gauss_seidel_) gauss_seidel_.emplace(model_);
  } else {
    gauss_seidel_.reset();
    if (!jacobi_) jacobi_.emplace(buffers_.tet_count);
  }
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
  return passes;
}

void GpuSolver::step() {
  for (int s = 0; s < settings_.substeps; ++s) {
    time_ += settings_.substep();
    motions_.upload(model_, time_);
    run(begin_);
    run(first_iteration_);
    for (int i = 1; i < settings_.iterations; ++i) run(iteration_);
    run(end_);
  }
}

void GpuSolver::reset() { upload(reference::initial_state(model_)); }

void GpuSolver::upload(const reference::State& state) {
  buffers_.upload_state(model_, state);
  time_ = state.time;
}

void GpuSolver::set_settings(const SolverSettings& settings) {
  const bool same_method = settings.method == settings_.method;
  settings_ = settings;
  if (!same_method) record();
  buffers_.upload_step(model_, settings_.substep());
}

void GpuSolver::materials_changed() {
  buffers_.upload_step(model_, settings_.substep());
  buffers_.upload_materials(model_);
  if (const Features features = features_of(model_); features != features_) {
    features_ = features;
    record();
  }
}

void GpuSolver::set_grab(const std::vector<GrabSpring>& springs) {
  if (grab_.set(springs)) record();
}

void GpuSolver::set_color(ColorBy color) {
  if (color == color_) return;
  color_ = color;
  surface_.record(programs_, buffers_, features_, color_);
}

void GpuSolver::request_diagnostics() { diagnostics_.request(buffers_, grab_, settings_.substep()); }

std::uint64_t GpuSolver::dispatches_per_step() const {
  const std::uint64_t iterations = first_iteration_.size() + (settings_.iterations - 1) * iteration_.size();
  return settings_.substeps * (begin_.size() + iterations + end_.size());
}

}  // namespace fascia
