// Formats numbers as text: the shortest digits that read back to the same double.
#pragma once
#include <charconv>
#include <concepts>
#include <string>
#include <string_view>

namespace fascia {

template <class T>
concept Number = !std::same_as<T, char> && (std::integral<T> || std::floating_point<T>);

class NumberText {
 public:
  NumberText& add(std::string_view text) {
    text_ += text;
    return *this;
  }
  NumberText& add(char c) {
    text_ += c;
    return *this;
  }
  template <Number T>
  NumberText& add(T value) {
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
    text_.append(digits, static_cast<std::size_t>(end - digits));
    return *this;
  }
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

}  // namespace fascia
