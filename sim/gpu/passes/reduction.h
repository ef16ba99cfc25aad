// Sizes of the sums that kernels compute with shaders/common/reduce.glsl.
#pragma once
#include <algorithm>
#include <cstdint>

#include "gl/program.h"

namespace fascia {

struct Reduction {
  std::uint32_t lanes;     // invocations that share the items, a multiple of kGroup
  std::uint32_t partials;  // partial sums that remain to be added

  static constexpr std::uint32_t kGroup = 64;  // GROUP_SIZE of shaders/common/io.glsl

  static constexpr std::uint32_t whole_groups(std::uint32_t lanes) { return (lanes + kGroup - 1) / kGroup * kGroup; }

  /// Nothing without items. `wide`: the kernel does more work per item than an addition and, on a GPU, needs as many
  /// invocations as any other kernel.
  Reduction(const gl::ProgramCache& programs, std::uint32_t items, bool wide = false) {
    // Software renderers get few lanes, whose sums one invocation adds; large meshes get enough lanes for many cores.
    // GPUs get many lanes, and a tree leaves one sum per group.
    const bool tree = programs.sums_in_groups();
    const std::uint32_t share = !tree  ? 16
                                : wide ? 1
                                       : 4,
                        most = !tree  ? std::max(256u, items / 128)
                               : wide ? 32768
                                      : 4096;
    lanes = items == 0 ? 0 : whole_groups(std::clamp(items / share, kGroup, most));
    partials = tree ? lanes / kGroup : lanes;
  }
};

/// Lanes of a sum whose partial sums, one per lane, the CPU adds: few enough to read back cheaply, enough to fill a
/// GPU.
inline std::uint32_t lanes_read_back(std::uint32_t items, std::uint32_t most) {
  return items == 0 ? 0 : Reduction::whole_groups(std::clamp(items / 16, Reduction::kGroup, most));
}

}  // namespace fascia
