// Bytes made smaller for a file that carries others (zlib format, RFC 1950).
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace fascia {

std::string deflated(std::string_view bytes);

/// Whether so many bytes can come out of `deflated` ones at all: to be asked before memory is taken for them.
bool can_inflate_to(std::uint64_t bytes, std::uint64_t deflated);

/// The `size` bytes that were deflated. Nothing unless the data are whole, sound and of that size.
std::optional<std::string> inflated(std::string_view data, std::uint64_t size);

}  // namespace fascia
