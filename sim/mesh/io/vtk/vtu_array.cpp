#include "sim/mesh/io/vtk/vtu_array.h"

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <map>

#include "base/byte_text.h"

namespace fascia {
namespace {

constexpr std::uint64_t zlib_best = 1032;  // largest compression factor of deflate

VtkType type_of(Scanner& in, const XmlElement& array) {
  static const std::map<std::string_view, VtkType> types = {
      {"Int8", VtkType::int8},      {"UInt8", VtkType::uint8},   {"Int16", VtkType::int16},
      {"UInt16", VtkType::uint16},  {"Int32", VtkType::int32},   {"UInt32", VtkType::uint32},
      {"Int64", VtkType::int64},    {"UInt64", VtkType::uint64}, {"Float32", VtkType::float32},
      {"Float64", VtkType::float64}};
  const std::string name = array.attribute("type");
  const auto type = types.find(name);
  if (type == types.end())
    fail_at(in, array, "type is " + in_quotes(name), "expected Int8 to UInt64, Float32 or Float64");
  return type->second;
}

}  // namespace

std::uint64_t xml_count(Scanner& in, const XmlElement& element, const char* key) {
  const std::string text = element.attribute(key);
  std::uint64_t value = 0;
  const auto [stop, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (status != std::errc{} || stop != text.data() + text.size()) {
    fail_at(in, element, std::string(key) + " is " + in_quotes(text), "expected a whole number, not negative");
  }
  return value;
}

VtuArrays::VtuArrays(Scanner& in, const XmlElement& root) : in_(in) {
  const std::string order = root.attribute("byte_order", "LittleEndian");
  if (order != "LittleEndian" && order != "BigEndian") {
    fail_at(in, root, "byte_order is " + in_quotes(order), "expected LittleEndian or BigEndian");
  }
  swapped_ = (order == "LittleEndian") != (std::endian::native == std::endian::little);
  const std::string header = root.attribute("header_type", "UInt32");
  if (header != "UInt32" && header != "UInt64") {
    fail_at(in, root, "header_type is " + in_quotes(header), "expected UInt32 or UInt64");
  }
  header_size_ = header == "UInt32" ? 4 : 8;
  const std::string compressor = root.attribute("compressor");
  if (!compressor.empty() && compressor != "vtkZLibDataCompressor") {
    fail_at(in, root, "compressor is " + in_quotes(compressor), "expected vtkZLibDataCompressor or none");
  }
  deflated_ = !compressor.empty();

  const XmlElement* const appended = root.child("AppendedData");
  if (!appended) return;
  const std::string encoding = appended->attribute("encoding");
  if (encoding != "raw" && encoding != "base64") {
    fail_at(in, *appended, "encoding is " + in_quotes(encoding), "expected raw or base64");
  }
  const std::string_view content = in.data().substr(0, appended->text_end);
  const std::size_t underscore = content.find_first_not_of(" \t\r\n", appended->text_begin);
  if (underscore == std::string_view::npos || content[underscore] != '_') {
    fail_at(in, *appended, "does not begin with '_'", "expected '_' before the data");
  }
  appended_ = {underscore + 1, appended->text_end, encoding == "base64"};
}

std::string VtuArrays::encoding(const XmlElement& array) const {
  const std::string format = array.attribute("format", "ascii");
  if (format == "ascii") return "ASCII";
  const std::string place = format == "binary"               ? "base64"
                            : appended_ && appended_->base64 ? "appended base64"
                                                             : "appended raw";
  return place + (deflated_ ? ", zlib" : "");
}

template <class T>
std::vector<T> VtuArrays::values(const XmlElement& array, std::optional<std::size_t> expected, bool finite) const {
  const VtkType type = type_of(in_, array);
  if (std::is_same_v<T, std::int64_t> && (type == VtkType::float32 || type == VtkType::float64)) {
    fail_at(in_, array, "type is " + array.attribute("type"), "expected an integer type");
  }
  std::vector<T> out;
  if (array.attribute("format", "ascii") == "ascii") {
    Scanner text(in_.where(), in_.data().substr(0, array.text_end));
    text.seek(array.text_begin);
    text.set_section("DataArray " + in_quotes(array.attribute("Name")));
    if (expected) out.reserve(std::min(*expected, text.remaining() / 2 + 1));
    while (!text.at_end()) {
      if constexpr (std::is_same_v<T, double>) {
        out.push_back(finite ? text.coordinate("a coordinate") : text.number<double>("a value"));
      } else {
        out.push_back(text.number<T>("a value"));
      }
    }
  } else {
    const std::string raw = bytes(array);
    const std::size_t size = size_of(type);
    if (raw.size() % size != 0) {
      fail_at(in_, array, "holds " + std::to_string(raw.size()) + " bytes",
              "expected a multiple of " + std::to_string(size));
    }
    out = vtk_values<T>(raw, type, swapped_);
  }
  if (expected && out.size() != *expected) {
    fail_at(in_, array, "holds " + std::to_string(out.size()) + " values", "expected " + std::to_string(*expected));
  }
  return out;
}
template std::vector<double> VtuArrays::values(const XmlElement&, std::optional<std::size_t>, bool) const;
template std::vector<std::int64_t> VtuArrays::values(const XmlElement&, std::optional<std::size_t>, bool) const;

std::string VtuArrays::bytes(const XmlElement& array) const {
  const std::string format = array.attribute("format");
  std::string_view text = in_.data().substr(array.text_begin, array.text_end - array.text_begin);
  bool base64 = true;
  if (format == "appended") {
    if (!appended_) fail_at(in_, array, "format is appended", "expected an AppendedData element");
    const std::uint64_t offset = xml_count(in_, array, "offset");
    const std::size_t size = appended_->end - appended_->begin;
    if (offset > size)
      fail_at(in_, array, "offset is " + std::to_string(offset), "expected at most " + std::to_string(size));
    text = in_.data().substr(appended_->begin + offset, size - offset);
    base64 = appended_->base64;
  } else if (format != "binary") {
    fail_at(in_, array, "format is " + in_quotes(format), "expected ascii, binary or appended");
  }
  return deflated_ ? inflated(array, text, base64) : plain(array, text, base64);
}

std::uint64_t VtuArrays::header_word(std::string_view words, std::size_t index) const {
  const VtkType type = header_size_ == 4 ? VtkType::uint32 : VtkType::uint64;
  return static_cast<std::uint64_t>(
      vtk_values<std::int64_t>(words.substr(index * header_size_, header_size_), type, swapped_)[0]);
}

/// The first `size` bytes that a base64 text encodes; *used: the number of characters read.
std::string VtuArrays::decoded(const XmlElement& array, std::string_view text, std::uint64_t size,
                               std::size_t* used) const {
  std::optional<Base64> out;
  if (size <= text.size()) out = base64_decoded(text, size);
  if (!out || out->bytes.size() < size) {
    fail_at(in_, array, "is not " + std::to_string(size) + " bytes of base64", "expected a complete array");
  }
  out->bytes.resize(size);
  *used = out->used;
  return std::move(out->bytes);
}

std::string VtuArrays::plain(const XmlElement& array, std::string_view text, bool base64) const {
  std::size_t used = 0;
  const std::string header =
      base64 ? decoded(array, text, header_size_, &used) : std::string(text.substr(0, header_size_));
  if (header.size() < header_size_) fail_at(in_, array, "has no room for its size", "expected a complete array");
  const std::uint64_t size = header_word(header, 0);
  if (size > text.size() || (!base64 && size > text.size() - header_size_)) {
    fail_at(in_, array, "claims " + std::to_string(size) + " bytes but only " + std::to_string(text.size()) + " follow",
            "expected a complete file");
  }
  if (!base64) return std::string(text.substr(header_size_, size));
  return decoded(array, text, header_size_ + size, &used).substr(header_size_);
}

std::string VtuArrays::inflated(const XmlElement& array, std::string_view text, bool base64) const {
  // header: number of blocks, size of a block, size of the last one (0: as the others), compressed size of each
  std::size_t used = 0;
  const auto header_of = [&](std::uint64_t words) {
    if (words > text.size() / header_size_) {
      fail_at(in_, array, "claims " + std::to_string(words - 3) + " blocks", "expected a complete array");
    }
    used = words * header_size_;
    return base64 ? decoded(array, text, used, &used) : std::string(text.substr(0, used));
  };
  const std::uint64_t blocks = header_word(header_of(3), 0);
  if (blocks > text.size())
    fail_at(in_, array, "claims " + std::to_string(blocks) + " blocks", "expected a complete array");
  const std::string header = header_of(3 + blocks);
  const std::uint64_t block_size = header_word(header, 1), last_size = header_word(header, 2);

  std::uint64_t deflated_size = 0, size = 0;
  for (std::uint64_t b = 0; b < blocks; ++b) {
    const std::uint64_t from = header_word(header, 3 + b);
    const std::uint64_t to = b + 1 == blocks && last_size != 0 ? last_size : block_size;
    if (from > text.size() || to / zlib_best > from) {
      fail_at(in_, array,
              "block " + std::to_string(b) + " claims " + std::to_string(from) + " bytes for " + std::to_string(to),
              "expected no more than the file holds");
    }
    deflated_size += from;
    size += to;
  }
  std::string_view body = text.substr(used);
  std::string body_bytes;
  if (base64) {
    body_bytes = decoded(array, body, deflated_size, &used);
    body = body_bytes;
  }
  if (deflated_size > body.size()) {
    fail_at(in_, array,
            "claims " + std::to_string(deflated_size) + " bytes but only " + std::to_string(body.size()) + " follow",
            "expected a complete file");
  }
  std::string out(size, '\0');
  std::size_t done = 0;
  for (std::uint64_t b = 0; b < blocks; ++b) {
    const std::uint64_t from = header_word(header, 3 + b);
    uLongf to = b + 1 == blocks && last_size != 0 ? last_size : block_size;
    const uLongf expected = to;
    const int status =
        uncompress(reinterpret_cast<Bytef*>(out.data() + done), &to, reinterpret_cast<const Bytef*>(body.data()), from);
    if (status != Z_OK || to != expected) {
      fail_at(in_, array, "block " + std::to_string(b) + " does not inflate to " + std::to_string(expected) + " bytes",
              "expected zlib data");
    }
    body.remove_prefix(from);
    done += to;
  }
  return out;
}

}  // namespace fascia
