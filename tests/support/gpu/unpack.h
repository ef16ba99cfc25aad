// Vectors in a buffer of the GPU, in double precision.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "gl/buffer.h"
#include "shaders/shared/types.h"

namespace fascia::test {

/// The xyz of the vec4 of a buffer.
inline std::vector<Eigen::Vector3d> unpack(const gl::Buffer& buffer) {
  std::vector<Eigen::Vector3d> out;
  for (const shared::vec4& v : buffer.read<shared::vec4>()) out.emplace_back(v.x, v.y, v.z);
  return out;
}

}  // namespace fascia::test
