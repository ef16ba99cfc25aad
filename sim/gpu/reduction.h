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

  /// `wide`: the kernel does more for an item than to add it up, and on a GPU needs as many invocations as another one.
  Reduction(const gl::ProgramCache& programs, std::uint32_t items, bool wide = false) {
    // Software renderers get few lanes, whose sums one invocation adds up, of large meshes enough for many cores; GPUs get many, and a
    // tree leaves one sum per group.
    const bool tree = programs.load_path() == gl::LoadPath::storage;
    const std::uint32_t share = !tree ? 16 : wide ? 1 : 4, most = !tree ? std::max(256u, items / 128) : wide ? 32768 : 4096;
    lanes = (std::clamp(items / share, kGroup, most) + kGroup - 1) / kGroup * kGroup;
    partials = tree ? lanes / kGroup : lanes;
  }
};

}  // namespace fascia
