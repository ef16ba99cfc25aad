#include "sim/output/sample_history.h"

#include <algorithm>

namespace fascia {
namespace {

bool earlier(const Sample& sample, double time) { return sample.time < time; }

}  // namespace

void SampleHistory::add(const Sample& sample) {
  while (!samples_.empty() && samples_.back().time >= sample.time) samples_.pop_back();
  // Removes half at once, so that the rest is moved only rarely.
  if (samples_.size() >= kMost) samples_.erase(samples_.begin(), samples_.begin() + kMost / 2);
  samples_.push_back(sample);
}

std::span<const Sample> part(std::span<const Sample> samples, double begin, double end) {
  auto first = std::lower_bound(samples.begin(), samples.end(), begin, earlier);
  auto last = std::lower_bound(first, samples.end(), end, earlier);
  if (first != samples.begin()) --first;
  if (last != samples.end()) ++last;
  return {first, last};
}

const Sample* SampleHistory::nearest(double time) const {
  if (samples_.empty()) return nullptr;
  const auto after = std::lower_bound(samples_.begin(), samples_.end(), time, earlier);
  if (after == samples_.begin()) return &samples_.front();
  if (after == samples_.end()) return &samples_.back();
  const auto before = after - 1;
  return time - before->time < after->time - time ? &*before : &*after;
}

}  // namespace fascia
