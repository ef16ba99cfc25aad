// A bounds-checked walk over a file held in memory: words, numbers and raw binary, which mesh formats mix freely. Every
// error names the location: the line in a text file, the byte and section in a binary one.
#pragma once
#include <charconv>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace fascia {

class Scanner {
 public:
  /// Begins after a UTF-8 byte order mark, which some editors write.
  Scanner(std::string where, std::string_view data) : where_(std::move(where)), data_(data) {
    if (data.starts_with("\xef\xbb\xbf")) seek(3);
  }

  const std::string& where() const { return where_; }
  std::string_view data() const { return data_; }
  std::size_t offset() const { return pos_; }
  std::size_t remaining() const { return data_.size() - pos_; }
  void seek(std::size_t offset) { pos_ = word_ = offset; }
  /// The next error names this offset.
  void blame(std::size_t offset) { word_ = offset; }

  /// Errors name bytes from here on, not lines.
  void locate_by_byte() { by_byte_ = true; }
  /// Part of the file that errors mention, such as "$Nodes"; empty for none.
  void set_section(std::string_view section) { section_ = section; }
  /// '#' starts a comment that runs to the end of the line.
  void skip_comments() { comments_ = true; }
  /// A comma separates words as a blank does.
  void skip_commas() { commas_ = true; }
  /// Binary numbers have the other byte order.
  void set_swapped(bool swapped) { swapped_ = swapped; }

  // --- text
  bool at_end();                            // nothing but blanks and comments left
  bool at_line_end();                       // nothing but blanks and comments left on this line
  std::string_view word(const char* what);  // the next word, across lines
  std::string_view peek_word();             // the next word without taking it; empty at the end
  bool take(std::string_view text);         // the next word if it is this one; else the position is unchanged
  std::string_view line();                  // the rest of this line, without its end
  void end_line(const char* what);          // fails unless at_line_end(), then goes to the next line
  bool skip_past(std::string_view text);    // false if it does not occur
  template <class T>
  T number(const char* what);  // the next word, across lines
  template <class T>
  T number_on_line(const char* what);           // fails at the end of the line
  double coordinate(const char* what);          // a finite number
  double coordinate_on_line(const char* what);  // a finite number, on this line
  /// A count of items that each take at least `bytes_each` bytes of the rest of the file.
  std::size_t count(const char* things, std::size_t bytes_each);
  void check_count(std::uint64_t count, const char* things, std::size_t bytes_each) const;

  // --- binary
  std::string_view bytes(std::size_t size, const char* what);
  template <class T>
  T binary(const char* what);
  template <class T = double>
  double binary_coordinate(const char* what);
  void skip(std::uint64_t size, const char* what);

  /// Throws Error with the location of the last word or binary number.
  [[noreturn]] void fail(const std::string& what, const std::string& expected) const;
  /// The location of an offset: "path:12" or "path: byte 99, $Nodes".
  std::string place(std::size_t offset) const;

 private:
  void skip_space(bool across_lines);
  bool is_separator(char c) const { return (comments_ && c == '#') || (commas_ && c == ','); }
  std::string_view current_word() const;
  [[noreturn]] void fail_number(const char* what, const char* kind) const;
  [[noreturn]] void fail_missing(const char* what);
  double check_finite(double value, const char* what) const;
  template <class T>
  T parse_number(const char* what);
  double beyond_range(std::size_t length) const;

  std::string where_;
  std::string_view data_;
  std::size_t pos_ = 0;
  std::size_t word_ = 0;  // start of the last word or number
  std::string section_;
  bool by_byte_ = false, comments_ = false, commas_ = false, swapped_ = false;
};

/// A piece of file content for one line of an error message: at most 24 bytes, other bytes escaped.
std::string in_quotes(std::string_view text);

template <class T>
T byte_swapped(T value) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  for (std::size_t i = 0; i < sizeof(T) / 2; ++i) std::swap(raw[i], raw[sizeof(T) - 1 - i]);
  std::memcpy(&value, raw, sizeof(T));
  return value;
}

template <class T>
T Scanner::parse_number(const char* what) {
  const char* const end = data_.data() + data_.size();
  const char* begin = data_.data() + pos_;
  if (begin != end && *begin == '+') ++begin;
  T value{};
  const auto [stop, status] = std::from_chars(begin, end, value);
  const bool ends =
      stop == end || *stop == ' ' || *stop == '\n' || *stop == '\t' || *stop == '\r' || is_separator(*stop);
  if constexpr (std::floating_point<T>) {
    if (status == std::errc::result_out_of_range) {
      value = static_cast<T>(beyond_range(static_cast<std::size_t>(stop - begin)));
    } else if (status != std::errc{}) {
      fail_number(what, "a number");
    }
    if (!ends) fail_number(what, "a number");
  } else {
    if (status != std::errc{} || !ends)
      fail_number(what, std::unsigned_integral<T> ? "a whole number, not negative" : "a whole number");
  }
  pos_ = static_cast<std::size_t>(stop - data_.data());
  return value;
}

template <class T>
T Scanner::number(const char* what) {
  skip_space(true);
  if (pos_ == data_.size()) fail_missing(what);
  return parse_number<T>(what);
}

template <class T>
T Scanner::number_on_line(const char* what) {
  skip_space(false);
  if (pos_ == data_.size() || data_[pos_] == '\n') fail_missing(what);
  return parse_number<T>(what);
}

template <class T>
double Scanner::binary_coordinate(const char* what) {
  return check_finite(static_cast<double>(binary<T>(what)), what);
}

template <class T>
T Scanner::binary(const char* what) {
  T value;
  std::memcpy(&value, bytes(sizeof(T), what).data(), sizeof(T));
  return swapped_ ? byte_swapped(value) : value;
}

}  // namespace fascia
