// Where tets in pairs that share a face (sim/tet_pairing.h) leave what is gathered at every vertex: for kernels that include
// shaders/common/pair_slots.glsl, and for those that gather.
#pragma once
#include "render/gl/compute_pass.h"
#include "sim/gpu/sim_buffers.h"

namespace fascia {

struct TetPairs {
  /// Of the order that the tets have now.
  explicit TetPairs(const SimBuffers& buffers);

  gl::Buffer slots;       // uvec4 [pairs and single tets] slots of all corners but y, sorted by vertex
  gl::Buffer fifth_slot;  // uint [the same] the slot of y
  gl::Buffer slot_begin;  // uint [vertex_count + 1] first slot of each vertex

  /// `bindings` and what scatters.
  gl::ComputePass::Bindings with_slots(gl::ComputePass::Bindings bindings) const;
};

}  // namespace fascia
