// Springs that follow grabs for thousands of steps, as little as has to be kept of them: once all of them, then how far
// each grab has led its own. What is kept gives back the same bits, so the springs themselves are first put where it
// says.
#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "sim/model/grab_spring.h"

namespace fascia {

/// From the springs that a GrabTrack restarted with: the first `count` by one offset, the next ones by another.
struct GrabMove {
  struct Part {
    std::size_t count;
    Eigen::Vector3d offset;  // of the targets [m]
    bool operator==(const Part&) const = default;
  };
  std::vector<Part> parts;
  bool operator==(const GrabMove&) const = default;
};

class GrabTrack {
 public:
  void restart(std::vector<GrabSpring> springs) { base_ = std::move(springs); }
  /// The move that `springs` are, which may change in their last bits to be exactly that one. Nothing if they are no
  /// move of the others.
  std::optional<GrabMove> follow(std::vector<GrabSpring>& springs) const;
  bool fits(const GrabMove& move) const;
  std::vector<GrabSpring> moved(const GrabMove& move) const;  // which fits

 private:
  std::vector<GrabSpring> base_;
};

}  // namespace fascia
