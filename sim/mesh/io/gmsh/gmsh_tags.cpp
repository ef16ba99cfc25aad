#include "sim/mesh/io/gmsh/gmsh_tags.h"

#include <algorithm>

namespace fascia {
namespace {

constexpr std::size_t kLongestTag = 64;

/// The word that begins at `at`; empty if it is too long for a tag.
std::string_view tag_at(std::string_view data, std::size_t at) {
  const std::string_view text = data.substr(at, kLongestTag + 1);
  const std::size_t end = std::min(text.find_first_of(" \t\r\n\v\f"), text.size());
  return end > kLongestTag ? std::string_view() : text.substr(0, end);
}

}  // namespace

std::string gmsh_end_tag(std::string_view section) {
  const bool upper = std::none_of(section.begin(), section.end(), [](char c) { return c >= 'a' && c <= 'z'; });
  return (upper ? "$END" : "$End") + std::string(section.substr(1));
}

bool is_gmsh_end_tag(std::string_view word) { return word.starts_with("$End") || word.starts_with("$END"); }

GmshTags::GmshTags(std::string_view data) {
  for (std::size_t at = data.find('$'); at != std::string_view::npos; at = data.find('$', at + 1)) {
    const std::string_view tag = tag_at(data, at);
    const bool begins_line = at == 0 || data[at - 1] == '\n' || data[at - 1] == '\r';
    if (is_gmsh_end_tag(tag) || (begins_line && tag.size() > 1)) offsets_[tag].push_back(at);
  }
}

std::optional<std::size_t> GmshTags::find(std::string_view tag, std::size_t from) const {
  const auto found = offsets_.find(tag);
  if (found == offsets_.end()) return std::nullopt;
  const auto offset = std::lower_bound(found->second.begin(), found->second.end(), from);
  return offset == found->second.end() ? std::nullopt : std::optional(*offset);
}

}  // namespace fascia
