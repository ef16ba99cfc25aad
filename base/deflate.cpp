#include "base/deflate.h"

#include <zlib.h>

#include <algorithm>
#include <limits>

#include "base/error.h"

namespace fascia {
namespace {

constexpr std::uint64_t kBest = 1032;                             // largest compression factor of deflate
constexpr std::size_t kBlock = std::numeric_limits<uInt>::max();  // zlib's limit per call

Bytef* bytes_of(const char* data) {
  return reinterpret_cast<Bytef*>(const_cast<char*>(data));
}  // zlib does not write to its input

}  // namespace

std::string deflated(std::string_view bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string out(size, '\0');
  // Mesh files consist mostly of digits: higher levels take several times as long to save a few percent.
  if (compress2(bytes_of(out.data()), &size, bytes_of(bytes.data()), static_cast<uLong>(bytes.size()), Z_BEST_SPEED) !=
      Z_OK)
    throw Error("zlib", "compressing failed", "expected free memory");
  out.resize(size);
  out.shrink_to_fit();
  return out;
}

bool can_inflate_to(std::uint64_t bytes, std::uint64_t deflated) { return bytes / kBest <= deflated; }

std::optional<std::string> inflated(std::string_view data, std::uint64_t size) {
  if (!can_inflate_to(size, data.size()) || data.size() > kBlock || size >= kBlock) return std::nullopt;
  std::string out(static_cast<std::size_t>(size) + 1, '\0');  // one more byte, so that longer data is noticed
  uLongf made = static_cast<uLongf>(out.size()), used = static_cast<uLongf>(data.size());
  if (uncompress2(bytes_of(out.data()), &made, bytes_of(data.data()), &used) != Z_OK) return std::nullopt;
  if (made != size || used != data.size()) return std::nullopt;
  out.resize(static_cast<std::size_t>(size));
  return out;
}

}  // namespace fascia
