// Pairs of tets, or vertices, that need more work than the others: the first kernel puts them on a list, and a second
// dispatch processes the list (DEFERS and DEFERRED in shaders/common/io.glsl). Where invocations run in lockstep a
// branch saves nothing; with the list, upright tets do not pay for the singular values of inverted ones.
#pragma once
#include <cstdint>
#include <vector>

#include "gl/buffer.h"

namespace fascia {

/// The capacity that a method needs: the number of lists that are filled before all are emptied, and of items on all of
/// them together.
struct Deferral {
  std::uint32_t lists = 0, items = 0;
  bool operator==(const Deferral&) const = default;
};

struct DeferredTets {
  explicit DeferredTets(Deferral room)
      : most(room), lists("deferred_items", sizeof(std::uint32_t) * (4 * room.lists + room.items)) {
    std::vector<std::uint32_t> words;
    for (std::uint32_t list = 0; list < most.lists; ++list) words.insert(words.end(), {0, 1, 1, 0});
    none = gl::Buffer("no_deferred", words);
  }

  std::uint32_t count() const {  // on all lists; waits for the GPU
    std::vector<std::uint32_t> heads(4 * most.lists);
    lists.download(0, heads.size() * sizeof(std::uint32_t), heads.data());
    std::uint32_t count = 0;
    for (std::uint32_t list = 0; list < most.lists; ++list) count += heads[4 * list + 3];
    return count;
  }

  Deferral most;
  gl::Buffer lists;  // uint, for each list: work groups of the second dispatch, 1, 1, number of items; then the items
                     // of all lists
  gl::Buffer none;   // uint [4 * most.lists] the contents of empty lists
};

}  // namespace fascia
