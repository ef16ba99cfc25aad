// Whether tools are so near to the tissue that a step needs the kernels of contact: one test of boxes on the CPU. The
// box around the tissue and its largest speed are read from the GPU, and grow from then on by the farthest that the
// tissue may move: twice its inertial motion, and a motion that forces add, by which its speed may grow in every step.
// They are read again where that is too much to tell, and after eight steps. Whether a step has contact depends on the
// state at the last restart() and on inputs alone, so that steps from that state repeat to the bit.
#pragma once
#include <Eigen/Geometry>
#include <optional>

#include "gl/compute_pass.h"
#include "sim/gpu/passes/sim_buffers.h"
#include "sim/model/model.h"
#include "sim/tool/tool_motion.h"

namespace fascia {

class ToolWatch {
 public:
  static constexpr int kLongest = 8;  // steps from one reading to the next

  /// `buffers` must outlive this object.
  ToolWatch(gl::ProgramCache& programs, const SimBuffers& buffers);

  /// Of a step.
  struct Step {
    const ToolMotion& tools;
    double duration;          // [s]
    Eigen::Vector3d gravity;  // [m/s^2]
    Eigen::AlignedBox3d led;  // where grabs and prescribed motions lead the tissue [m]; may be empty
  };
  /// Whether a tool may touch the tissue in the next step; called once for each. Waits for the GPU where it reads.
  bool is_near(const Model& model, const Step& step);
  /// The state was replaced, or forces have changed: reads again before the next step.
  void restart() { age_ = kLongest; }

 private:
  void read();
  bool is_near(const Model& model, const Step& step, int age) const;

  const SimBuffers& buffers_;
  gl::Buffer bounds_;  // uint [7]
  gl::ComputePass measure_;
  Eigen::AlignedBox3d box_;  // [m]
  double speed_ = 0;         // [m/s]
  int age_ = kLongest;       // steps since these were read
  bool near_ = false;        // as of then
};

}  // namespace fascia
