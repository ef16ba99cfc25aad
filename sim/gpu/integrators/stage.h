// The passes of a stage (sim/integrators/stage.h): the prediction and the strains that begin every stage, and the
// velocities at its end.
#pragma once
#include "gl/compute_pass.h"
#include "sim/gpu/passes/recording.h"

namespace fascia {

/// The start of a stage's iterations: u~, or u + duration v, where the velocity leads.
struct Start {
  bool gravity = true;
  // uint [vertex_count]: not 0 for vertices that start at u~ even if `gravity` is false; null: none
  const gl::Buffer* unconstrained = nullptr;
};

/// The inertial prediction of every stage (shaders/sim/step/predict.comp). `copy_begin`: uint [vertex_count + 1], the
/// number of copies before each vertex, for methods that split a vertex's mass between copies; null for others.
/// `active`: limits the pass to these vertices; null: all.
gl::ComputePass prediction(gl::ProgramCache& programs, const SimBuffers& buffers, const gl::Buffer* copy_begin,
                           const Start& start = {}, const ActiveSet* active = nullptr);

/// u~ of what moves at the centroids of quadratic tets (shaders/sim/quadratic/quadratic_predict.comp). After the
/// prediction.
gl::ComputePass centroid_prediction(const Recording& recording);

/// eps* of damped materials (shaders/sim/step/previous_strain.comp). Before the prediction where the integrator
/// extrapolates, else after it.
Passes strains_at_start(const Recording& recording);

/// The last pass of every stage (shaders/sim/step/velocity.comp): velocities, and the index of a vertex that
/// diverged.
gl::ComputePass velocity_update(const Recording& recording);

}  // namespace fascia
