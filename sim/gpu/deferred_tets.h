// Pairs of tets, or vertices, that need more work than the others: the kernel that meets them puts them on a list, and a second dispatch
// goes through the list (DEFERS and DEFERRED in shaders/common/io.glsl). Where invocations run in lockstep a branch saves nothing; this
// way upright tets do not pay for the singular values of those turned inside out.
#pragma once
#include <cstdint>
#include <vector>

#include "render/gl/buffer.h"

namespace fascia {

struct DeferredTets {
  explicit DeferredTets(std::uint32_t most) : items("deferred_items", sizeof(std::uint32_t) * most) {}

  std::uint32_t most() const { return static_cast<std::uint32_t>(items.bytes() / sizeof(std::uint32_t)); }

  gl::Buffer items;  // uint [most]
  gl::Buffer count{"deferred_count", std::vector<std::uint32_t>{0, 1, 1, 0}};  // work groups of the second dispatch, 1, 1, items
  gl::Buffer none{"no_deferred", std::vector<std::uint32_t>{0, 1, 1, 0}};
};

}  // namespace fascia
