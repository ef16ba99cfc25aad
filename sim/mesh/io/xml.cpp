#include "sim/mesh/io/xml.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace fascia {
namespace {

constexpr int deepest = 32;  // nesting; VTK needs 6

bool is_name(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-' || c == ':' || c == '.';
}
bool is_white(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

class Parser {
 public:
  explicit Parser(Scanner& in) : in_(in), text_(in.data()) {}

  XmlElement document() {
    pos_ = in_.offset();
    skip_misc();
    if (!starts("<")) fail("has no element", "expected an XML element");
    XmlElement root = element(0);
    skip_misc();
    if (pos_ < text_.size()) fail("something follows the last element", "expected the end of the file");
    return root;
  }

 private:
  [[noreturn]] void fail(const std::string& what, const std::string& expected) {
    in_.blame(std::min(pos_, text_.size()));
    in_.fail(pos_ >= text_.size() ? "the file ends inside XML" : what,
             pos_ >= text_.size() ? "expected a complete file" : expected);
  }

  bool starts(std::string_view with) const { return text_.substr(pos_).starts_with(with); }
  void skip_spaces() {
    while (pos_ < text_.size() && is_white(text_[pos_])) ++pos_;
  }
  void skip_to(std::string_view end) {
    const std::size_t found = text_.find(end, pos_);
    pos_ = found == std::string_view::npos ? text_.size() : found + end.size();
    if (found == std::string_view::npos) fail("", "");
  }

  /// Skips blanks, comments, processing instructions and a document type.
  void skip_misc() {
    for (;;) {
      skip_spaces();
      if (starts("<!--")) {
        skip_to("-->");
      } else if (starts("<?")) {
        skip_to("?>");
      } else if (starts("<!DOCTYPE")) {
        skip_to(">");
      } else {
        return;
      }
    }
  }

  std::string name(const char* of_what) {
    const std::size_t begin = pos_;
    while (pos_ < text_.size() && is_name(text_[pos_])) ++pos_;
    if (begin == pos_) fail(std::string("the name of ") + of_what + " is missing", "expected letters");
    return std::string(text_.substr(begin, pos_ - begin));
  }

  void expect(char c) {
    skip_spaces();
    if (pos_ >= text_.size() || text_[pos_] != c) {
      fail("found " + in_quotes(text_.substr(pos_, 1)), std::string("expected '") + c + "'");
    }
    ++pos_;
  }

  std::string value() {
    skip_spaces();
    const char quote = pos_ < text_.size() ? text_[pos_] : '\0';
    if (quote != '"' && quote != '\'') fail("the value of an attribute is not quoted", "expected '\"'");
    const std::size_t end = text_.find(quote, ++pos_);
    if (end == std::string_view::npos) {
      pos_ = text_.size();
      fail("", "");
    }
    std::string out;
    while (pos_ < end) {
      if (text_[pos_] == '<') fail("found '<' in the value of an attribute", "expected '&lt;'");
      out += text_[pos_] == '&' ? reference(end) : text_[pos_++];
    }
    pos_ = end + 1;
    return out;
  }

  char reference(std::size_t limit) {
    static constexpr std::array<std::pair<std::string_view, char>, 5> known = {
        {{"&lt;", '<'}, {"&gt;", '>'}, {"&amp;", '&'}, {"&quot;", '"'}, {"&apos;", '\''}}};
    for (const auto& [text, c] : known) {
      if (pos_ + text.size() <= limit && starts(text)) {
        pos_ += text.size();
        return c;
      }
    }
    fail("found " + in_quotes(text_.substr(pos_, 8)), "expected &lt; &gt; &amp; &quot; or &apos;");
  }

  XmlElement element(int depth) {
    if (depth > deepest)
      fail("elements are nested too deeply", "expected at most " + std::to_string(deepest) + " levels");
    XmlElement out;
    out.at = pos_;
    expect('<');
    out.name = name("an element");
    for (;;) {
      skip_spaces();
      if (starts("/>")) {
        pos_ += 2;
        return out;
      }
      if (starts(">")) break;
      std::string key = name("an attribute");
      expect('=');
      out.attributes.emplace_back(std::move(key), value());
    }
    out.text_begin = ++pos_;
    if (out.name == "AppendedData") {
      const std::size_t end = text_.rfind("</AppendedData");
      if (end == std::string_view::npos || end < pos_) {
        pos_ = text_.size();
        fail("", "");
      }
      pos_ = out.text_end = end;
    } else {
      out.text_end = std::min(text_.find('<', pos_), text_.size());
      content(out, depth);
    }
    pos_ += 2;  // </
    const std::size_t closing = pos_;
    const std::string closed = name("a closing element");
    if (closed != out.name) {
      pos_ = closing;
      fail("</" + closed + "> closes <" + out.name + ">", "expected </" + out.name + ">");
    }
    expect('>');
    return out;
  }

  void content(XmlElement& out, int depth) {
    for (;;) {
      pos_ = std::min(text_.find('<', pos_), text_.size());
      if (pos_ == text_.size()) fail("", "");
      if (starts("</")) return;
      if (starts("<!--") || starts("<?")) {
        skip_misc();
      } else {
        out.children.push_back(element(depth + 1));
      }
    }
  }

  Scanner& in_;
  std::string_view text_;
  std::size_t pos_ = 0;
};

}  // namespace

std::string XmlElement::attribute(std::string_view key, std::string_view absent) const {
  for (const auto& [present, value] : attributes) {
    if (present == key) return value;
  }
  return std::string(absent);
}

const XmlElement* XmlElement::child(std::string_view child_name) const {
  const auto found =
      std::find_if(children.begin(), children.end(), [&](const XmlElement& e) { return e.name == child_name; });
  return found == children.end() ? nullptr : &*found;
}

std::string_view xml_root_name(std::string_view text) {
  for (std::size_t at = text.find('<'); at != text.npos; at = text.find('<', at + 1)) {
    if (text.substr(at).starts_with("<!--")) {
      at = std::min(text.find("-->", at), text.size());
      continue;
    }
    const std::size_t begin = at + 1;
    std::size_t end = begin;
    while (end < text.size() && is_name(text[end])) ++end;
    if (end > begin) return text.substr(begin, end - begin);
  }
  return {};
}

XmlElement parse_xml(Scanner& in) { return Parser(in).document(); }

void fail_at(Scanner& in, const XmlElement& element, const std::string& what, const std::string& expected) {
  const std::string name = element.attribute("Name");
  in.blame(element.at);
  in.fail(element.name + (name.empty() ? "" : " " + in_quotes(name)) + ": " + what, expected);
}

}  // namespace fascia
