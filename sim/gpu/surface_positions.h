// Positions for drawing, x = X + u in float32, with the heat map's scalar in w. Made by the GPU for the GPU.
#pragma once
#include <vector>

#include "render/gl/compute_pass.h"
#include "sim/gpu/features.h"

namespace fascia {

class SurfacePositions {
 public:
  explicit SurfacePositions(const SimBuffers& buffers);
  /// Passes for the heat map that is shown; none costs one pass.
  void record(gl::ProgramCache& programs, const SimBuffers& buffers, const Features& features, ColorBy color);
  void run() const;
  const gl::Buffer& positions() const { return positions_; }  // vec4 [vertex_count]

 private:
  gl::Buffer positions_;
  std::vector<gl::ComputePass> passes_;
};

}  // namespace fascia
