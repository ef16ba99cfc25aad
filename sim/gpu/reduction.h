// Sizes of the sums that kernels make with shaders/common/reduce.glsl.
#pragma once
#include <algorithm>
#include <cstdint>

#include "render/gl/program.h"

namespace fascia {

struct Reduction {
  std::uint32_t lanes;     // invocations that share the items, a multiple of kGroup
  std::uint32_t partials;  // sums that are left to add up

  static constexpr std::uint32_t kGroup = 64;  // GROUP_SIZE of shaders/common/io.glsl

  Reduction(const gl::ProgramCache& programs, std::uint32_t items) {
    // Software renderers get few lanes, whose sums one invocation adds up; GPUs get many, and a tree leaves one sum per group.
    const bool tree = programs.load_path() == gl::LoadPath::storage;
    lanes = (std::clamp<std::uint32_t>(items / (tree ? 4 : 16), kGroup, tree ? 4096 : 256) + kGroup - 1) / kGroup * kGroup;
    partials = tree ? lanes / kGroup : lanes;
  }
};

}  // namespace fascia
