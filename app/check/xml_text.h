// Text for XML and HTML.
#pragma once
#include <string>
#include <string_view>

namespace fascia {

/// Escapes what would be markup, for contents and attributes. Bytes that are not UTF-8 and characters that XML cannot
/// represent are replaced by "?".
std::string xml_text(std::string_view text);

}  // namespace fascia
