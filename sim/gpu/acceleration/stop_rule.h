// Ends a substep's iterations on the GPU at a relative residual of solver.tolerance. The passes that would follow are
// dispatched indirectly, and a check sets their numbers of work groups to zero, so nothing is read back and the frame
// does not wait.
#pragma once
#include <initializer_list>
#include <optional>

#include "sim/gpu/passes/reduction.h"
#include "sim/gpu/passes/step_gradient.h"

namespace fascia {

class StopRule {
 public:
  /// `gradient`: the start of the method's iterations, which makes a check before each of them cheap. Without one
  /// (null) the rule computes a gradient of its own, before every kOwnInterval-th iteration only.
  StopRule(const gl::ProgramCache& programs, const SimBuffers& buffers, const StepGradient* gradient);

  /// Appends the check to the passes that run before the first iteration of a substep and before later ones, and
  /// changes the passes `before` and `governed` so that a check can end them.
  void record(const Recording& recording, Passes& before_first, Passes& before,
              std::initializer_list<Passes*> governed);
  static constexpr int kOwnInterval = 8;
  int interval() const { return own_ ? kOwnInterval : 1; }  // iterations from one check to the next

  const gl::Buffer& state() const {
    return state_;
  }  // uint [2]: iterations of the last substep, and of all substeps since construction

 private:
  Passes check(const Recording& recording, bool first, std::uint32_t pass_count) const;

  std::optional<StepGradient> own_;
  const gl::Buffer& gradient_;
  Reduction sums_;
  gl::Buffer residual_partials_, full_groups_, arguments_, state_;
};

}  // namespace fascia
