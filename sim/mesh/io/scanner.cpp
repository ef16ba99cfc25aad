#include "sim/mesh/io/scanner.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "base/error.h"

namespace fascia {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }
bool is_space(char c) { return c == '\n' || is_blank(c); }

std::string printable(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c >= ' ' && c <= '~') {
      out += c;
    } else {
      constexpr char digits[] = "0123456789abcdef";
      const auto byte = static_cast<unsigned char>(c);
      out += {'\\', 'x', digits[byte >> 4], digits[byte & 15]};
    }
  }
  return out;
}

}  // namespace

std::string in_quotes(std::string_view text) {
  constexpr std::size_t longest = 24;
  return "'" + printable(text.substr(0, longest)) + (text.size() > longest ? "...'" : "'");
}

void Scanner::skip_space(bool across_lines) {
  while (pos_ < data_.size()) {
    const char c = data_[pos_];
    if (is_blank(c) || (across_lines && c == '\n') || (commas_ && c == ',')) {
      ++pos_;
    } else if (comments_ && c == '#') {
      pos_ = std::min(data_.find('\n', pos_), data_.size());
    } else {
      break;
    }
  }
  word_ = pos_;
}

std::string_view Scanner::current_word() const {
  std::size_t end = word_;
  while (end < data_.size() && !is_space(data_[end]) && !is_separator(data_[end])) ++end;
  return data_.substr(word_, end - word_);
}

bool Scanner::at_end() {
  skip_space(true);
  return pos_ == data_.size();
}

bool Scanner::at_line_end() {
  skip_space(false);
  return pos_ == data_.size() || data_[pos_] == '\n';
}

std::string_view Scanner::peek_word() {
  skip_space(true);
  return current_word();
}

std::string_view Scanner::word(const char* what) {
  const std::string_view found = peek_word();
  if (found.empty()) fail_missing(what);
  pos_ += found.size();
  return found;
}

bool Scanner::take(std::string_view text) {
  const std::size_t before = pos_;
  const bool same = peek_word() == text;
  pos_ = same ? pos_ + text.size() : before;
  return same;
}

std::string_view Scanner::line() {
  word_ = pos_;
  const std::size_t end = std::min(data_.find('\n', pos_), data_.size());
  std::string_view text = data_.substr(pos_, end - pos_);
  pos_ = std::min(end + 1, data_.size());
  if (!text.empty() && text.back() == '\r') text.remove_suffix(1);
  return text;
}

void Scanner::end_line(const char* what) {
  if (!at_line_end()) fail(in_quotes(current_word()) + " follows " + what, "expected the end of the line");
  if (pos_ < data_.size()) ++pos_;
}

bool Scanner::skip_past(std::string_view text) {
  const std::size_t found = data_.find(text, pos_);
  if (found == std::string_view::npos) return false;
  pos_ = word_ = found + text.size();
  return true;
}

double Scanner::coordinate(const char* what) { return check_finite(number<double>(what), what); }
double Scanner::coordinate_on_line(const char* what) { return check_finite(number_on_line<double>(what), what); }

double Scanner::check_finite(double value, const char* what) const {
  if (!std::isfinite(value)) {
    fail(std::string(what) + " is " + (std::isnan(value) ? "nan" : "infinite"), "expected a finite number");
  }
  return value;
}

std::size_t Scanner::count(const char* things, std::size_t bytes_each) {
  const auto value = number<std::uint64_t>((std::string("the number of ") + things).c_str());
  check_count(value, things, bytes_each);
  return value;
}

void Scanner::check_count(std::uint64_t count, const char* things, std::size_t bytes_each) const {
  // +1: the last line of a text may lack a line break
  if (count > (remaining() + 1) / bytes_each) {
    fail(
        "claims " + std::to_string(count) + " " + things + " but only " + std::to_string(remaining()) + " bytes follow",
        "expected a complete file");
  }
}

std::string_view Scanner::bytes(std::size_t size, const char* what) {
  word_ = pos_;
  if (size > remaining()) fail_missing(what);
  pos_ += size;
  return data_.substr(word_, size);
}

void Scanner::skip(std::uint64_t size, const char* what) {
  word_ = pos_;
  if (size > remaining()) fail_missing(what);
  pos_ += size;
}

std::string Scanner::place(std::size_t offset) const {
  if (by_byte_) {
    return where_ + ": byte " + std::to_string(offset) + (section_.empty() ? "" : ", " + printable(section_));
  }
  const auto end = data_.begin() + static_cast<std::ptrdiff_t>(std::min(offset, data_.size()));
  return where_ + ":" + std::to_string(1 + std::count(data_.begin(), end, '\n'));
}

void Scanner::fail(const std::string& what, const std::string& expected) const {
  throw Error(place(word_), (by_byte_ || section_.empty() ? "" : printable(section_) + ": ") + what, expected);
}

void Scanner::fail_number(const char* what, const char* kind) const {
  fail(std::string(what) + " is " + in_quotes(current_word()), std::string("expected ") + kind);
}

void Scanner::fail_missing(const char* what) {
  if (word_ < data_.size() && data_[word_] == '\n' && !by_byte_) {
    fail(std::string("the line ends before ") + what, "expected more numbers on it");
  }
  word_ = data_.size();
  fail(std::string("the file ends before ") + what, "expected a complete file");
}

double Scanner::beyond_range(std::size_t length) const {
  const std::string copy(data_.substr(pos_, length + 1));
  return std::strtod(copy.c_str(), nullptr);  // 0 or a denormal for 1e-400, infinity for 1e400
}

}  // namespace fascia
