#include "sim/mesh/io/tag_map.h"

#include <algorithm>

namespace fascia {

std::optional<std::size_t> TagMap::assign(const std::vector<std::int64_t>& tags) {
  *this = {};
  if (tags.empty()) return std::nullopt;
  size_ = tags.size();
  const auto [low, high] = std::minmax_element(tags.begin(), tags.end());
  first_ = *low;
  last_ = *high;
  const std::uint64_t span = static_cast<std::uint64_t>(last_) - static_cast<std::uint64_t>(first_);
  if (span <= 4 * std::uint64_t{tags.size()} + 64) {
    dense_.assign(span + 1, absent);
    for (std::size_t i = 0; i < tags.size(); ++i) {
      std::uint32_t& slot = dense_[static_cast<std::size_t>(tags[i] - first_)];
      if (slot != absent) return i;
      slot = static_cast<std::uint32_t>(i);
    }
    return std::nullopt;
  }
  sparse_.reserve(tags.size());
  for (std::size_t i = 0; i < tags.size(); ++i) sparse_.emplace_back(tags[i], static_cast<std::uint32_t>(i));
  std::sort(sparse_.begin(), sparse_.end());
  const auto same = [](const auto& a, const auto& b) { return a.first == b.first; };
  const auto twice = std::adjacent_find(sparse_.begin(), sparse_.end(), same);
  if (twice != sparse_.end()) return (twice + 1)->second;
  return std::nullopt;
}

std::optional<std::uint32_t> TagMap::find_sparse(std::int64_t tag) const {
  const auto found = std::lower_bound(sparse_.begin(), sparse_.end(), std::pair(tag, std::uint32_t{0}));
  if (found == sparse_.end() || found->first != tag) return std::nullopt;
  return found->second;
}

}  // namespace fascia
