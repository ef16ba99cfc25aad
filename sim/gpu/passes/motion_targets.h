// The vertices that follow the scene's prescribed motions. Targets are computed in double precision on the CPU and
// uploaded once per substep. Nothing is allocated for scenes without motions.
#pragma once
#include <cstdint>
#include <vector>

#include "gl/compute_pass.h"
#include "sim/gpu/passes/sim_buffers.h"

namespace fascia {

class MotionTargets {
 public:
  explicit MotionTargets(const Model& model);
  bool empty() const { return vertices_.empty(); }
  /// Uploads the displacements of time `t` [s] unless they are already uploaded.
  void upload(const Model& model, double t);
  gl::ComputePass pass(gl::ProgramCache& programs, const SimBuffers& buffers) const;

 private:
  struct Source {
    std::uint32_t motion, index;  // indices into Model::motions and into the motion's vertices
  };
  std::vector<std::uint32_t> vertices_;
  std::vector<Source> sources_;  // [vertices_]; where motions overlap, the last one moves the vertex
  double last_change_;           // [s] time when every motion has ended
  double uploaded_ = -1;         // [s]
  gl::Buffer vertex_, target_;
};

}  // namespace fascia
