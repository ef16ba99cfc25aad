// Positions of the section tags in a Gmsh file. Text and binary are searched alike; in binary an end tag may follow the
// last number without a line break.
#pragma once
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fascia {

/// "$EndNodes" of "$Nodes", "$ENDNOD" of "$NOD".
std::string gmsh_end_tag(std::string_view section);
/// Whether a word is an end tag of any section.
bool is_gmsh_end_tag(std::string_view word);

class GmshTags {
 public:
  /// One pass over `data`, which must outlive the tags.
  explicit GmshTags(std::string_view data);

  /// Offset of the first such tag at or after `from`: an end tag anywhere, another tag only at the beginning of a line.
  std::optional<std::size_t> find(std::string_view tag, std::size_t from) const;

 private:
  std::map<std::string_view, std::vector<std::size_t>> offsets_;  // ascending
};

}  // namespace fascia
