#include "app/check/junit.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <string_view>

#include "base/number_text.h"

namespace fascia {
namespace {

// The number of bytes of the UTF-8 character at the beginning of a text, or 0 for other bytes and for characters that
// XML 1.0 forbids.
std::size_t character_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  const unsigned first = byte(0);
  if (first < 0x80) return first >= 0x20 || first == '\t' || first == '\n' ? 1 : 0;
  const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4) return 0;
  std::uint32_t code = first & (0x7fu >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return 0;
    code = code << 6 | (byte(i) & 0x3f);
  }
  const bool longer_than_needed = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
  const bool no_character = (code >= 0xd800 && code <= 0xdfff) || code == 0xfffe || code == 0xffff || code > 0x10ffff;
  return longer_than_needed || no_character ? 0 : length;
}

std::string escaped(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    switch (length == 0 ? '?' : text[0]) {
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '&':
        result += "&amp;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\n':
        result += "&#10;";
        break;  // a plain line break in an attribute would be read as a space
      case '\t':
        result += "&#9;";
        break;
      default:
        result += length == 0 ? "?" : text.substr(0, length);
    }
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return result;
}

std::string seconds_text(double seconds) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3f", seconds);
  return text;
}

std::string counts(const std::vector<JunitCase>& cases) {
  const auto count = [&](JunitCase::Verdict verdict) {
    return std::to_string(
        std::count_if(cases.begin(), cases.end(), [&](const JunitCase& c) { return c.verdict == verdict; }));
  };
  double seconds = 0;
  for (const JunitCase& c : cases) seconds += c.seconds;
  return " tests=\"" + std::to_string(cases.size()) + "\" failures=\"" + count(JunitCase::Verdict::failed) +
         "\" errors=\"" + count(JunitCase::Verdict::error) + "\" time=\"" + seconds_text(seconds) + "\"";
}

std::string case_xml(const std::string& suite, const JunitCase& c) {
  std::string xml = "    <testcase classname=\"" + escaped(suite) + "\" name=\"" + escaped(c.name) + "\" time=\"" +
                    seconds_text(c.seconds) + "\">\n";
  if (!c.properties.empty()) {
    xml += "      <properties>\n";
    for (const auto& [name, value] : c.properties)
      xml += "        <property name=\"" + escaped(name) + "\" value=\"" + NumberText().add(value).take() + "\"/>\n";
    xml += "      </properties>\n";
  }
  if (c.verdict != JunitCase::Verdict::passed) {
    const std::string kind = c.verdict == JunitCase::Verdict::failed ? "failure" : "error";
    xml += "      <" + kind + " message=\"" + escaped(c.message) + "\" type=\"" + kind + "\">" + escaped(c.details) +
           "</" + kind + ">\n";
  }
  if (!c.output.empty()) xml += "      <system-out>" + escaped(c.output) + "</system-out>\n";
  return xml + "    </testcase>\n";
}

}  // namespace

std::string junit_xml(const std::string& suite, const std::string& timestamp, const std::vector<JunitCase>& cases) {
  std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites" + counts(cases) +
                    ">\n  <testsuite name=\"" + escaped(suite) + "\"" + counts(cases) + " skipped=\"0\" timestamp=\"" +
                    escaped(timestamp) + "\">\n";
  for (const JunitCase& c : cases) xml += case_xml(suite, c);
  return xml + "  </testsuite>\n</testsuites>\n";
}

}  // namespace fascia
