// Samples in the order of their times, enough for a long session.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "sim/output/sample.h"

namespace fascia {

/// The samples, ascending in time, from `begin` to `end` [s], and one more at each side, where a line continues.
std::span<const Sample> part(std::span<const Sample> samples, double begin, double end);

class SampleHistory {
 public:
  static constexpr std::size_t kMost = 72000;  // 20 minutes at 60 per second

  /// Discards samples later than the new one, after a reset or a step back.
  void add(const Sample& sample);
  void clear() { samples_.clear(); }
  std::span<const Sample> all() const { return samples_; }
  std::span<const Sample> between(double begin, double end) const { return part(samples_, begin, end); }
  /// The sample nearest in time; null without samples.
  const Sample* nearest(double time) const;

 private:
  std::vector<Sample> samples_;
};

}  // namespace fascia
