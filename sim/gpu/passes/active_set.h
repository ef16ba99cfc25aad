// The vertices and tets that a step solves while the others rest: lists on the GPU, for kernels compiled with
// LISTED (common/io.glsl).
#pragma once
#include <cstdint>

#include "gl/buffer.h"

namespace fascia {

struct ActiveSet {
  gl::Buffer vertices;   // uint [vertex_count of the mesh], the first vertex_count entries are valid: the vertices that
                         // move, then their neighbors, which are kept in place
  gl::Buffer pairs;      // uint [pairs and single tets], pair_count valid: all with a tet at a moving vertex
  gl::Buffer clusters;   // uint, clusters_of() these pairs (force_clusters.h); absent where nothing sums in clusters
  gl::Buffer quadratic;  // uint [quadratic tets], quadratic_count valid: the same
  std::uint32_t moving_count = 0, vertex_count = 0, pair_count = 0, quadratic_count = 0;
  std::uint32_t cluster_invocations = 0;  // a work group for each
  std::uint32_t work = 0;                 // SimBuffers::work_of() these
};

}  // namespace fascia
