#include "base/suggest.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace fascia {
namespace {

bool is_separator(char c) { return c == '_' || c == '-' || c == ' ' || c == '\t'; }

/// Lower case, with one kind of separator.
std::string folded(std::string_view word) {
  std::string text(word);
  for (char& c : text) c = is_separator(c) ? '_' : c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return text;
}

std::string without_separators(std::string text) {
  std::erase_if(text, is_separator);
  return text;
}

}  // namespace

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);  // distances of the first i characters of a to each prefix of b
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] != b[j - 1]);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row.back();
}

std::string nearest(std::string_view word, const std::vector<std::string>& candidates) {
  constexpr std::size_t kLongestWord = 64;  // longer words are not typing mistakes, and the distance has quadratic cost
  if (word.size() > kLongestWord) return "";
  const std::string text = folded(word), letters = without_separators(text);
  std::string best;
  std::pair<std::size_t, std::size_t> best_distance;  // without separators; of the original words, among equals
  for (const std::string& candidate : candidates) {
    const std::string other_text = folded(candidate), other_letters = without_separators(other_text);
    const std::pair distance{edit_distance(letters, other_letters), edit_distance(word, candidate)};
    const bool is_near = 2 * edit_distance(text, other_text) <= std::max(text.size(), other_text.size()) ||
                         2 * distance.first < std::max(letters.size(), other_letters.size());
    if (!is_near || (!best.empty() && !(distance < best_distance))) continue;
    best = candidate;
    best_distance = distance;
  }
  return best;
}

std::string perhaps(std::string_view word, const std::vector<std::string>& candidates) {
  const std::string best = nearest(word, candidates);
  return best.empty() ? "" : ", perhaps \"" + best + "\"";
}

std::string join(const std::vector<std::string>& words) {
  constexpr std::size_t kMost = 24;
  std::string text;
  for (std::size_t w = 0; w < std::min(words.size(), kMost); ++w) text += (w ? ", " : "") + words[w];
  if (words.size() > kMost) text += " and " + std::to_string(words.size() - kMost) + " more";
  return text;
}

}  // namespace fascia
