// The kernel features that a scene needs. They become defines (shaders/sim/feature_*.glsl), so that unused features are
// not compiled, bound or allocated.
#pragma once
#include <set>

#include "gl/compute_pass.h"
#include "sim/gpu/passes/sim_buffers.h"

namespace fascia {

struct Features {
  bool material_per_tet = false;
  bool damping = false;
  bool quadratic = false;          // some tets (sim/elements/quadratic_tet.h)
  std::set<MaterialModel> models;  // of the materials
  bool operator==(const Features&) const = default;
};

Features features_of(const Model& model);
gl::Defines defines_of(const Features& features);

/// Adds the buffers that the feature includes declare. `previous_strain` is used only with damping.
gl::ComputePass::Bindings with_material(gl::ComputePass::Bindings bindings, const Features& features,
                                        const SimBuffers& buffers);
gl::ComputePass::Bindings with_damping(gl::ComputePass::Bindings bindings, const Features& features,
                                       const gl::Buffer& previous_strain);

/// Of the strains that damping remembers, as shaders/sim/elasticity/feature_damping.glsl reads them.
std::size_t bytes_of_previous_strain(const gl::ProgramCache& programs, const SimBuffers& buffers);

/// Adds the buffers of kernels that process pairs of linear tets (shaders/common/tet_pair.glsl).
gl::ComputePass::Bindings with_pairs(gl::ComputePass::Bindings bindings, const SimBuffers& buffers);
gl::ComputePass::Constants constants_of_pairs(const SimBuffers& buffers);
/// States what such a kernel reads: of a pair the shape and the vertices of the first tet.
void count_bytes_of_pairs(gl::ComputePass& pass, const SimBuffers& buffers);
/// Adds the same, and the buffers of kernels that write to the corners of pairs of tets
/// (shaders/common/pair_slots.glsl).
gl::ComputePass::Bindings with_slots(gl::ComputePass::Bindings bindings, const SimBuffers& buffers);

/// The same of kernels that process quadratic tets (shaders/common/quadratic_tet.glsl, quadratic_slots.glsl).
gl::ComputePass::Bindings with_quadratic(gl::ComputePass::Bindings bindings, const SimBuffers& buffers);
gl::ComputePass::Constants constants_of_quadratic(const SimBuffers& buffers);
gl::Defines defines_of_quadratic(gl::Defines defines, const SimBuffers& buffers);
gl::ComputePass::Bindings with_quadratic_slots(gl::ComputePass::Bindings bindings, const SimBuffers& buffers);

}  // namespace fascia
