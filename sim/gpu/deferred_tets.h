// Pairs of tets, or vertices, that need more work than the others: the kernel that meets them puts them on a list, and a second dispatch
// goes through the list (DEFERS and DEFERRED in shaders/common/io.glsl). Where invocations run in lockstep a branch saves nothing; this
// way upright tets do not pay for the singular values of those turned inside out.
#pragma once
#include <cstdint>
#include <vector>

#include "render/gl/buffer.h"

namespace fascia {

struct DeferredTets {
  explicit DeferredTets(std::uint32_t most) : list("deferred_items", sizeof(std::uint32_t) * (4 + most)) {}

  std::uint32_t most() const { return static_cast<std::uint32_t>(list.bytes() / sizeof(std::uint32_t)) - 4; }
  std::uint32_t count() const {  // waits for the GPU
    std::uint32_t count = 0;
    list.download(3 * sizeof count, sizeof count, &count);
    return count;
  }

  gl::Buffer list;  // uint [4 + most] work groups of the second dispatch, 1, 1, number of items; then the items
  gl::Buffer none{"no_deferred", std::vector<std::uint32_t>{0, 1, 1, 0}};
};

}  // namespace fascia
