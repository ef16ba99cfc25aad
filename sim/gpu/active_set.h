// The vertices and tets that a step solves when the others rest. Lists on the GPU, for kernels compiled with LISTED (common/io.glsl).
#pragma once
#include <cstdint>

#include "render/gl/buffer.h"

namespace fascia {

struct ActiveSet {
  gl::Buffer vertices;  // uint [vertex_count of the mesh], of which the first vertex_count count: those that move, then those beside them,
                        // which are held where they are
  gl::Buffer tets;      // uint [tet_count of the mesh], of which the first tet_count count: all around the vertices that move
  std::uint32_t moving_count = 0, vertex_count = 0, tet_count = 0;
};

}  // namespace fascia
