// Positions for drawing, x = X + u in float32, with the heat map's scalar in w: first the mesh vertices, then the
// vertices of surfaces embedded in the tets. Computed and used on the GPU.
#pragma once
#include <vector>

#include "gl/compute_pass.h"
#include "sim/gpu/contact/contact_term.h"
#include "sim/gpu/passes/features.h"
#include "sim/gpu/readback/shown_range.h"
#include "sim/surface/embedding.h"

namespace fascia {

class SurfacePositions {
 public:
  SurfacePositions(const SimBuffers& buffers, const EmbeddedPoints& embedded);
  /// Passes for the shown heat map; without a heat map one pass.
  void record(gl::ProgramCache& programs, const SimBuffers& buffers, const Features& features, ColorBy color,
              ContactTerm& contact);
  void run() const;
  void set_vertex_errors(const std::vector<float>& errors);    // [vertex_count], of ColorBy::error and mesh_error
  ShownRange* range() { return range_ ? &*range_ : nullptr; }  // of the scalars; null without a heat map
  const gl::Buffer& positions() const { return positions_; }   // vec4 [vertex_count + embedded]

 private:
  std::uint32_t vertex_count_, embedded_count_;
  gl::Buffer positions_, embed_position_, embed_vertices_, embed_weights_;
  gl::Buffer embed_middles_, embed_middle_weights_;  // with points in quadratic tets
  gl::Buffer vertex_errors_;                         // float [vertex_count]; created at first use
  std::optional<ShownRange> range_;                  // with a heat map
  std::vector<gl::ComputePass> passes_;
};

}  // namespace fascia
