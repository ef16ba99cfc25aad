// A compact record of springs that follow grabs for thousands of steps: all springs once, then only the offset of each
// grab. The record restores the same bits, because the springs themselves are first rounded to it.
#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "sim/model/grab_spring.h"

namespace fascia {

/// Relative to the springs of the GrabTrack's last restart: the first `count` have one offset, the next ones another.
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
  /// The move that results in `springs`, whose last bits may change to match exactly. None if they are not a move of
  /// the stored springs.
  std::optional<GrabMove> follow(std::vector<GrabSpring>& springs) const;
  bool fits(const GrabMove& move) const;
  std::vector<GrabSpring> moved(const GrabMove& move) const;  // `move` must fit

 private:
  std::vector<GrabSpring> base_;
};

}  // namespace fascia
