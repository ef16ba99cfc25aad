// Compresses bytes for a file that carries others (zlib format, RFC 1950).
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace fascia {

std::string deflated(std::string_view bytes);

/// Whether `deflated` bytes can decompress to so many at all: checked before memory is allocated for them.
bool can_inflate_to(std::uint64_t bytes, std::uint64_t deflated);

/// The `size` original bytes. None unless the data is complete, valid and of that size.
std::optional<std::string> inflated(std::string_view data, std::uint64_t size);

}  // namespace fascia
