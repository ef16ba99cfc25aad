// Bytes as text: base64 (RFC 4648) as VTK writes it, possibly several padded streams in sequence, with blanks between
// them.
#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace fascia {

std::string base64_encoded(std::string_view bytes);

struct Base64 {
  std::string bytes;
  std::size_t used;  // characters of the text that belong to `bytes`
};
/// Decodes until there are `most` bytes or the text ends. None if the text is not base64.
std::optional<Base64> base64_decoded(std::string_view text, std::size_t most = static_cast<std::size_t>(-1));

}  // namespace fascia
