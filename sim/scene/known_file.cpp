#include "sim/scene/known_file.h"

#include <span>

#include "base/byte_hash.h"
#include "base/deflate.h"
#include "base/error.h"
#include "base/file.h"
#include "base/json/json_document.h"

namespace fascia {

std::uint64_t content_hash(std::string_view content) {
  ByteHash hash;
  hash.add({reinterpret_cast<const std::uint8_t*>(content.data()), content.size()});
  return hash.value();
}

bool has_content(const std::filesystem::path& place, const KnownFile& file) {
  std::error_code ec;
  if (!std::filesystem::is_regular_file(place, ec) || std::filesystem::file_size(place, ec) != file.size || ec)
    return false;
  try {
    return content_hash(read_file(place)) == file.hash;
  } catch (const Error&) {
    return false;
  }
}

std::string carried_content(const KnownFile& file, const std::string& where) {
  std::optional<std::string> content = inflated(*file.deflated, file.size);
  if (!content || content_hash(*content) != file.hash)
    throw Error(where + ": files: " + on_one_line(file.path), "its content is damaged",
                "expected " + std::to_string(file.size) + " bytes whose hash is " + hash_text(file.hash));
  return std::move(*content);
}

}  // namespace fascia
