// The most recent measurements, for plots of the last seconds.
#pragma once
#include <array>
#include <cstddef>

namespace fascia {

/// A ring of the latest values of a repeated measurement.
class RecentValues {
 public:
  void add(double value);
  double latest() const { return count_ ? values_[(next_ + values_.size() - 1) % values_.size()] : 0; }
  double median() const;  // of the last 30, as in stats.json (sim/output/stats.h)
  int count() const { return static_cast<int>(count_); }
  float at(int i) const {
    return values_[(next_ + values_.size() - count_ + static_cast<std::size_t>(i)) % values_.size()];
  }

 private:
  std::array<float, 200> values_{};
  std::size_t next_ = 0, count_ = 0;
};

}  // namespace fascia
