#include "app/ui/recent_values.h"

#include <algorithm>
#include <vector>

#include "sim/output/stats.h"

namespace fascia {

void RecentValues::add(double value) {
  values_[next_] = static_cast<float>(value);
  next_ = (next_ + 1) % values_.size();
  count_ = std::min(count_ + 1, values_.size());
}

double RecentValues::median() const {
  constexpr int kRecent = 30;
  std::vector<double> recent;
  for (int i = std::max(0, count() - kRecent); i < count(); ++i) recent.push_back(at(i));
  return percentiles(std::move(recent)).median;
}

}  // namespace fascia
