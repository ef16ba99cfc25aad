// Maps the vertex numbers of a file (sparse, in any order) to indices in the order of the file.
#pragma once
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace fascia {

class TagMap {
 public:
  /// tags[i] is the number of vertex i. Returns the index of a vertex that repeats an earlier number, if any.
  std::optional<std::size_t> assign(const std::vector<std::int64_t>& tags);

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }

  /// The index of the vertex with this number, or none if the file has no such vertex.
  std::optional<std::uint32_t> find(std::int64_t tag) const {
    if (!dense_.empty()) {
      if (tag < first_ || tag > last_) return std::nullopt;
      const std::uint32_t index = dense_[static_cast<std::size_t>(tag - first_)];
      return index == absent ? std::nullopt : std::optional(index);
    }
    return find_sparse(tag);
  }

 private:
  static constexpr std::uint32_t absent = 0xffffffff;
  std::optional<std::uint32_t> find_sparse(std::int64_t tag) const;

  std::size_t size_ = 0;
  std::int64_t first_ = 0, last_ = -1;
  std::vector<std::uint32_t> dense_;  // [last - first + 1], if that is not much larger than the number of vertices
  std::vector<std::pair<std::int64_t, std::uint32_t>> sparse_;  // else sorted by number
};

}  // namespace fascia
