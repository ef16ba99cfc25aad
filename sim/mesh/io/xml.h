// The subset of XML that VTK and FEBio files use: elements, attributes, text, comments. A malformed file is refused.
#pragma once
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim/mesh/io/scanner.h"

namespace fascia {

struct XmlElement {
  std::string name;
  std::vector<std::pair<std::string, std::string>> attributes;
  std::vector<XmlElement> children;
  std::size_t at = 0;          // offset of its '<' in the file
  std::size_t text_begin = 0;  // its text, up to its first child
  std::size_t text_end = 0;

  /// The value of an attribute, or `absent`.
  std::string attribute(std::string_view key, std::string_view absent = {}) const;
  const XmlElement* child(std::string_view child_name) const;
};

/// The name of the root element, or empty if there is none.
std::string_view xml_root_name(std::string_view text);

/// The root element. The content of an AppendedData element is skipped: it may be raw binary.
XmlElement parse_xml(Scanner& in);

/// Throws Error with the line and the name of an element.
[[noreturn]] void fail_at(Scanner& in, const XmlElement& element, const std::string& what, const std::string& expected);

}  // namespace fascia
