// Samples in the order of their times, as many as a long session needs.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "sim/output/sample.h"

namespace fascia {

class SampleHistory {
 public:
  static constexpr std::size_t kMost = 72000;  // 20 minutes at 60 per second

  /// Time that has gone back, by a reset or a step backwards, takes the samples after it away.
  void add(const Sample& sample);
  void clear() { samples_.clear(); }
  std::span<const Sample> all() const { return samples_; }
  /// Those from `begin` to `end` [s], and one more at each side, where a line goes on.
  std::span<const Sample> between(double begin, double end) const;
  /// The one nearest in time; nothing without samples.
  const Sample* nearest(double time) const;

 private:
  std::vector<Sample> samples_;
};

}  // namespace fascia
