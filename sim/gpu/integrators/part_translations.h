// Parts of the mesh that nothing holds or touches: the end of a stage moves each as a whole to where its momentum is
// that of its prediction. Inner forces do not change that of the exact step, but that of unfinished iterations: a
// vibrating cube gained or lost 1e-6 to 1e-5 of its momentum in a step of ten iterations. In contact between bodies
// and with tools sim/gpu/contact/body_motions.h does the same with the forces of contact, and along turns.
#pragma once
#include "sim/gpu/passes/recording.h"
#include "sim/model/unconstrained_parts.h"

namespace fascia {

class PartTranslations {
 public:
  /// `parts`: of the buffers' vertices.
  explicit PartTranslations(const UnconstrainedParts& parts);

  bool empty() const { return vertex_count_ == 0; }
  /// Before the velocities of a stage in which no external energy acts and nothing rests.
  Passes passes(const Recording& recording) const;

 private:
  static constexpr std::uint32_t kChunk = 512;                          // vertices whose sum one work group computes
  std::uint32_t vertex_count_ = 0, chunk_count_ = 0, most_chunks_ = 0;  // most: of a part
  gl::Buffer vertices_, chunk_begin_, chunks_, sums_;                   // shaders/sim/step/part_sums.comp
};

}  // namespace fascia
