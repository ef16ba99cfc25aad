// Reads the key "files" of a scene file: known data of the files that it refers to, and files that it carries.
#include <charconv>

#include "base/byte_text.h"
#include "base/deflate.h"
#include "sim/scene/scene_read.h"

namespace fascia {
namespace {

constexpr double kLargestFile = 1e15;  // [bytes]: whole numbers in a double

std::shared_ptr<const std::string> read_deflated(const Node& node, const Node& size, std::uint64_t bytes) {
  const std::string expected = "base64 (RFC 4648)";
  const std::string text = node.text(expected);
  std::optional<Base64> decoded = base64_decoded(text);
  if (!decoded || decoded->used != text.size() || decoded->bytes.empty()) node.refuse(expected);
  if (bytes > kMostCarried) size.refuse(range_text(0, kMostCarried, "bytes for a file that is carried"));
  if (!can_inflate_to(bytes, decoded->bytes.size()))
    size.refuse("a size that can come out of " + std::to_string(decoded->bytes.size()) + " deflated bytes");
  return std::make_shared<const std::string>(std::move(decoded->bytes));
}

}  // namespace

std::uint64_t read_hash(const Node& node) {
  const std::string expected = "16 hexadecimal digits", text = node.text(expected);
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, 16);
  if (text.size() != 16 || error != std::errc{} || end != text.data() + text.size()) node.refuse(expected);
  return value;
}

std::vector<KnownFile> read_files(const Node& node) {
  std::vector<KnownFile> files;
  for (const Node& element : node.elements("a list of files that the scene refers to")) {
    element.expect_object({"path", "size", "hash", "deflated"});
    KnownFile& file = files.emplace_back();
    const Node path = element.at("path", "the path of the file, as in the scene"), size = element.at("size", "bytes");
    file.path = path.text("the path of the file, as in the scene");
    file.size = static_cast<std::uint64_t>(size.number(0, kLargestFile, "bytes"));
    if (static_cast<double>(file.size) != size.number(0, kLargestFile, "bytes")) size.refuse("a whole number of bytes");
    file.hash = read_hash(element.at("hash", "the FNV-1a hash of its content, 16 hexadecimal digits"));
    if (const auto deflated = element.find("deflated")) file.deflated = read_deflated(*deflated, size, file.size);
  }
  return files;
}

}  // namespace fascia
