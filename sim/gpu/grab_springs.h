// Springs that pull a patch of vertices to targets: the mouse's grip on the tissue. Buffers exist only while something is held.
#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "render/gl/compute_pass.h"
#include "sim/gpu/sim_buffers.h"

namespace fascia {

struct GrabSpring {
  std::uint32_t vertex;
  Eigen::Vector3d target;  // displacement the spring pulls to [m]
  double stiffness;        // [N/m]
};

class GrabSprings {
 public:
  /// Replaces all springs. Returns true when their number or vertices changed, so that passes must be recorded again.
  bool set(const std::vector<GrabSpring>& springs);
  bool empty() const { return vertices_.empty(); }

  gl::ComputePass pull(gl::ProgramCache& programs, const SimBuffers& buffers, bool first) const;
  gl::ComputePass load(gl::ProgramCache& programs, const SimBuffers& buffers) const;  // for the residual
  void forget();  // the multipliers of the last substep, which the first iteration of the next one would do
  const gl::Buffer& multiplier() const { return multiplier_; }  // vec4 [count] h^2 times the force on the tissue [kg m]
  std::uint32_t count() const { return static_cast<std::uint32_t>(vertices_.size()); }

 private:
  std::vector<std::uint32_t> vertices_;
  gl::Buffer vertex_, target_, multiplier_;
};

}  // namespace fascia
