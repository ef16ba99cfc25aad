// The uniform block of shaders/common/frame.glsl as C++ sees it: vec4 only, so std140 and C++ agree on the
// layout.
#pragma once
#include <Eigen/Core>

namespace fascia {

struct FrameUniforms {
  using vec4 = Eigen::Vector4f;
#include "shaders/shared/frame.h"
};
static_assert(sizeof(FrameUniforms) % 16 == 0);

}  // namespace fascia
