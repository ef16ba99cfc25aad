#include "base/json/json_document.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "base/error.h"

namespace fascia {
namespace {

using nlohmann::json;

/// Builds the document from the parser's events, because only these show a repeated key.
class DocumentBuilder : public nlohmann::json_sax<json> {
 public:
  DocumentBuilder(std::string_view text, std::string where) : text_(text), where_(std::move(where)) {}

  json take() { return std::move(root_); }

  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(number_integer_t value) override { return add(value); }
  bool number_unsigned(number_unsigned_t value) override { return add(value); }
  bool number_float(number_float_t value, const string_t&) override { return add(value); }
  bool string(string_t& value) override { return add(std::move(value)); }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { return open(json::object()); }
  bool end_object() override { return close(); }
  bool start_array(std::size_t) override { return open(json::array()); }
  bool end_array() override { return close(); }

  bool key(string_t& key) override {
    if (open_.back()->contains(key)) {
      throw Error(where_ + ": " + path_of_key(path(), key), "is given twice", "expected each key once");
    }
    keys_.back() = std::move(key);
    return true;
  }

  bool parse_error(std::size_t position, const std::string&, const json::exception& error) override {
    // `position` counts the bytes read so far: the wrong one is the last of them.
    const std::size_t wrong = std::min(position > 0 ? position - 1 : 0, text_.size());
    const std::string why = reason(error.what());
    const bool in_value = why.find("invalid literal") != why.npos || why.find("invalid number") != why.npos;
    const bool too_large = why.find("number overflow") != why.npos;
    const auto word = in_value ? not_finite_at(wrong) : too_large ? std::optional(number_at(wrong)) : std::nullopt;
    const std::string_view before = text_.substr(0, word ? word->begin : wrong);
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const std::size_t newline = before.rfind('\n');  // npos + 1 is 0
    const std::size_t column = before.size() - (newline + 1) + 1;
    const std::string place = where_ + ":" + std::to_string(line) + ":" + std::to_string(column);
    if (too_large) throw Error(place, "is " + word->text + ", which no double holds", "expected at most 1.8e308");
    if (word) throw Error(place, "is " + word->text + ", which JSON does not have", "expected a finite number");
    throw Error(place, why, "");
  }

 private:
  struct Word {
    std::size_t begin;
    std::string text;
  };
  /// The word around a byte if it is one by which programs write numbers that are not finite.
  std::optional<Word> not_finite_at(std::size_t byte) const {
    const auto is_of_word = [&](std::size_t at) {
      const auto c = static_cast<unsigned char>(text_[at]);
      return std::isalpha(c) || c == '-' || c == '+';
    };
    std::size_t begin = byte, end = byte;
    while (begin > 0 && is_of_word(begin - 1)) --begin;
    while (end < text_.size() && is_of_word(end)) ++end;
    std::string name;
    for (const unsigned char c : text_.substr(begin, end - begin))
      if (std::isalpha(c)) name += static_cast<char>(std::tolower(c));
    if (name != "nan" && name != "inf" && name != "infinity") return std::nullopt;
    return Word{begin, std::string(text_.substr(begin, end - begin))};
  }

  /// The number that ends at a byte or before it.
  Word number_at(std::size_t byte) const {
    const auto last = text_.find_last_of("0123456789", byte), before = text_.find_last_not_of("0123456789+-.eE", last);
    const std::size_t begin = before + 1;  // npos + 1 is 0
    constexpr std::size_t kLongest = 60;
    const std::string number(text_.substr(begin, last + 1 - begin));
    return {begin, number.size() > kLongest ? number.substr(0, kLongest) + "..." : number};
  }

  /// The parser's message without its code, without the position (which precedes ours) and without a long quotation of
  /// the text.
  static std::string reason(std::string text) {
    constexpr std::size_t kLongest = 200;
    if (const auto at = text.find("] "); at != std::string::npos) text.erase(0, at + 2);
    if (const auto at = text.find("syntax error"); at != std::string::npos) text.erase(0, at);
    if (text.size() > kLongest) text = text.substr(0, kLongest) + "...";
    return text;
  }

  std::string path() const {
    std::string path;
    for (std::size_t depth = 0; depth + 1 < open_.size(); ++depth) {
      path =
          open_[depth]->is_array() ? path_of_element(path, open_[depth]->size() - 1) : path_of_key(path, keys_[depth]);
    }
    return path;
  }

  json& place(json value) {
    if (open_.empty()) return root_ = std::move(value);
    json& parent = *open_.back();
    if (!parent.is_array()) return parent[keys_.back()] = std::move(value);
    parent.push_back(std::move(value));
    return parent.back();
  }
  bool add(json value) {
    place(std::move(value));
    return true;
  }
  bool open(json value) {
    if (open_.size() == kDeepestNesting) {
      throw Error(where_, "is nested deeper than " + std::to_string(kDeepestNesting) + " levels", "expected a scene");
    }
    open_.push_back(&place(std::move(value)));
    keys_.emplace_back();
    return true;
  }
  bool close() {
    open_.pop_back();
    keys_.pop_back();
    return true;
  }

  std::string_view text_;
  std::string where_;
  json root_;
  std::vector<json*> open_;        // from the root to the innermost open container. Only the innermost one grows,
  std::vector<std::string> keys_;  // so the pointers stay valid. The last key read in each container.
};

}  // namespace

json parse_json(std::string_view text, const std::string& where) {
  DocumentBuilder builder(text, on_one_line(where));  // an option's text may hold anything
  json::sax_parse(text, &builder);
  return builder.take();
}

std::string on_one_line(std::string_view text) {
  const bool plain = std::none_of(text.begin(), text.end(), [](unsigned char c) { return c < ' '; });
  return plain ? std::string(text) : json(text).dump(-1, ' ', false, json::error_handler_t::replace);
}

std::string path_of_key(const std::string& parent, std::string_view key) {
  const std::string name = on_one_line(key);
  return parent.empty() ? name : parent + "." + name;
}

std::string path_of_element(const std::string& parent, std::size_t index) {
  return parent + "[" + std::to_string(index) + "]";
}

std::string excerpt(const json& value) {
  constexpr std::size_t kLongest = 60;
  std::string text = value.dump(-1, ' ', false, json::error_handler_t::replace);
  if (text.size() > kLongest) text = text.substr(0, kLongest) + "...";
  return text;
}

}  // namespace fascia
