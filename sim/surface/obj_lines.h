// Splits a Wavefront file into lines and their keywords.
#pragma once
#include <algorithm>
#include <cstddef>
#include <string_view>

namespace fascia {

struct ObjLine {
  std::size_t number;           // from 1
  std::string_view word, rest;  // without surrounding white space; rest may be empty
};

/// Calls `take` for every line that is not empty. Lines end with CR, LF or both.
template <typename Take>
void for_each_obj_line(std::string_view content, const Take& take) {
  const auto trimmed = [](std::string_view text) {
    const std::size_t begin = text.find_first_not_of(" \t");
    return begin == text.npos ? std::string_view() : text.substr(begin, text.find_last_not_of(" \t") + 1 - begin);
  };
  for (std::size_t number = 1; !content.empty(); ++number) {
    const std::size_t end = std::min(content.find_first_of("\r\n"), content.size());
    const std::string_view line = trimmed(content.substr(0, end));
    const std::size_t stop = std::min(line.find_first_of(" \t"), line.size());
    if (!line.empty()) take(ObjLine{number, line.substr(0, stop), trimmed(line.substr(stop))});
    const bool two = end + 1 < content.size() && content[end] == '\r' && content[end + 1] == '\n';
    content.remove_prefix(std::min(end + (two ? 2 : 1), content.size()));
  }
}

}  // namespace fascia
