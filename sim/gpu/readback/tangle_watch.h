// The law squared keeps a tet upright up to large pressures, and so it would keep tissue that was pulled through itself
// in a tangle of upright tets, which come apart only through J = 0. While tissue is or may be tangled, the law
// therefore continues its logarithm from a larger share of the volume on: it is eased (kLeastVolumeRatio in
// sim/material/invariants.h). What is inverted all the same when that has ended is so under a load, such as weight over
// the edge of a support, where the pressure grows with the fineness of the mesh: then the law is firm
// (kLeastVolumeRatioOfFirm). The watch reads the least J of all tets every few steps, a reading late so that no step
// waits. The law of a step depends on the state at the last restart() and on inputs alone: runs repeat to the
// bit.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "gl/compute_pass.h"
#include "gl/fence.h"
#include "sim/gpu/passes/sim_buffers.h"

namespace fascia {

/// The law is eased from a look that finds a tet with J <= 0 until one that finds J > 0.3 everywhere, but at most for
/// two seconds after the last grab, tool or prescribed motion acted. After that it is its own, from the next look with
/// J <= 0 on firm, and stays so until all tets are above 0.3 or something handles the tissue.
class Easing {
 public:
  /// The least J at `time` [s]; `handled`: whether a grab, a tool or a prescribed motion acts.
  void look(double least, double time, bool handled);
  Hardness hardness() const { return hardness_; }

 private:
  Hardness hardness_ = Hardness::own;
  bool armed_ = true;  // the next inversion eases
  double until_ = 0;   // [s]
};

class TangleWatch {
 public:
  static constexpr int kInterval = 8;  // steps from one reading to the next

  /// Of all tets, of quadratic ones at the points where their law acts. `buffers` must outlive this object, and keep
  /// their tets' order.
  TangleWatch(gl::ProgramCache& programs, const SimBuffers& buffers);

  /// Of the next step; called once before each.
  Hardness hardness(double time, bool handled);
  /// The state was replaced.
  void restart();
  /// The state became that of another solver.
  void follow(const TangleWatch& leader) {
    restart();
    easing_ = leader.easing_;
  }

 private:
  gl::Buffer
      compression_;  // uint [1] (shaders/sim/readback/compression.comp, sim/quadratic/quadratic_compression.comp)
  gl::Buffer read_back_;
  std::vector<gl::ComputePass> measures_;
  gl::Fence fence_;
  Easing easing_;
  int age_ = kInterval;  // steps since the last reading
};

}  // namespace fascia
