// The values of the heat map that is shown, for a color bar that follows them: read without waiting.
#pragma once
#include <cstdint>
#include <optional>

#include "gl/buffer.h"
#include "gl/fence.h"

namespace fascia {

struct ShownValues {
  double smallest, largest;
  double usual;  // 98 percent of the values are at most this far from the middle
};

class ShownRange {
 public:
  /// `positions` vec4 [vertex_count or more], of which w is the scalar.
  ShownRange(const gl::Buffer& positions, std::uint32_t vertex_count);
  void set_middle(double middle) { middle_ = middle; }  // the neutral value of the scalar, or 0
  /// Queues a copy of the current scalars; the CPU can take it a frame later.
  void request();
  bool pending() const { return fence_.is_set(); }
  /// The values of the last request, once; with `wait`, waits for the GPU. None while they are not available or none is
  /// finite.
  std::optional<ShownValues> take(bool wait);

 private:
  const gl::Buffer& positions_;
  gl::Buffer staging_;
  double middle_ = 0;
  gl::Fence fence_;
};

}  // namespace fascia
