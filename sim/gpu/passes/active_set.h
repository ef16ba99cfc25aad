// The vertices and pairs of tets that a step solves when the others rest. Lists on the GPU, for kernels compiled with
// LISTED (common/io.glsl).
#pragma once
#include <cstdint>

#include "gl/buffer.h"

namespace fascia {

struct ActiveSet {
  gl::Buffer vertices;  // uint [vertex_count of the mesh], of which the first vertex_count count: those that move, then
                        // those beside them, which are held where they are
  gl::Buffer pairs;     // uint [pairs and single tets], of which the first pair_count count: all with a tet at a vertex
                        // that moves
  std::uint32_t moving_count = 0, vertex_count = 0, pair_count = 0;
  std::uint32_t tet_count = 0;  // in these pairs
};

}  // namespace fascia
