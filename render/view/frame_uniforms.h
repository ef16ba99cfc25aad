// The uniform block of shaders/common/frame.glsl in C++: vec4 only, so that the layouts of std140 and C++ agree.
#pragma once
#include <Eigen/Core>
#include <cstring>

namespace fascia {

struct FrameUniforms {
  FrameUniforms() { std::memset(static_cast<void*>(this), 0, sizeof *this); }  // Eigen's vectors begin as anything
  using vec4 = Eigen::Vector4f;
#include "shaders/shared/frame.h"
};
static_assert(sizeof(FrameUniforms) % 16 == 0);

}  // namespace fascia
