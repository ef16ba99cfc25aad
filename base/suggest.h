// Finds the known word nearest to a mistyped one, for error messages.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace fascia {

/// Smallest number of inserted, deleted or replaced characters that turns a into b.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The candidate nearest to `word` (the first of equals), or "" if all differ in more than half of their characters.
/// Case, "_", "-" and blanks are ignored, except among equals.
std::string nearest(std::string_view word, const std::vector<std::string>& candidates);

/// ", perhaps \"iterations\"" or "".
std::string perhaps(std::string_view word, const std::vector<std::string>& candidates);

/// "a, b, c"; of more than 24 words, which the keys of a scene are not, the first 24 "... and 976 more".
std::string join(const std::vector<std::string>& words);

}  // namespace fascia
