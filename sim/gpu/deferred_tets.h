// Tets that need more work than the others: the kernel that meets them puts them on a list, and a second dispatch goes through the list
// (DEFERS and DEFERRED in shaders/common/io.glsl). Where invocations run in lockstep a branch saves nothing; this way upright tets do
// not pay for the singular values of those turned inside out.
#pragma once
#include <cstdint>
#include <vector>

#include "render/gl/buffer.h"

namespace fascia {

struct DeferredTets {
  explicit DeferredTets(std::uint32_t tet_count) : tets("deferred_tets", sizeof(std::uint32_t) * tet_count) {}

  gl::Buffer tets;  // uint [tet_count]
  gl::Buffer count{"deferred_count", std::vector<std::uint32_t>{0, 1, 1, 0}};  // work groups of the second dispatch, tets
  gl::Buffer none{"no_deferred", std::vector<std::uint32_t>{0, 1, 1, 0}};
};

}  // namespace fascia
