#include "app/video/picture_sequence.h"

#include <algorithm>
#include <charconv>
#include <system_error>

#include "base/error.h"
#include "render/target/image.h"

namespace fascia {
namespace fs = std::filesystem;

std::optional<PictureNames> picture_names(const fs::path& pattern) {
  const std::string name = pattern.filename().string();
  const std::size_t percent = name.find('%'), end = name.find('d', percent);
  if (percent == std::string::npos || end == std::string::npos || name.find('%', percent + 1) != std::string::npos)
    return std::nullopt;
  PictureNames names{name.substr(0, percent), name.substr(end + 1), 0};
  const char* const first = name.data() + percent + 1;
  const char* const last = name.data() + end;
  if (first == last) return names;
  const auto [stop, error] = std::from_chars(first, last, names.digits);
  if (error != std::errc{} || stop != last || names.digits > 12) return std::nullopt;
  return names;
}

PictureSequence::PictureSequence(fs::path pattern, const FrameFormat& format, Provenance provenance)
    : folder_(pattern.parent_path()), format_(format), provenance_(std::move(provenance)) {
  const std::optional<PictureNames> names = picture_names(pattern);
  if (!names)
    throw Error(pattern.string(), "has no place for the number of a picture", "expected one as in frames/%05d.png");
  names_ = *names;
  std::error_code ec;
  if (!folder_.empty()) fs::create_directories(folder_, ec);
  if (ec) throw Error(folder_.string(), "cannot be made: " + ec.message(), "expected a folder for pictures");
}

void PictureSequence::write(const std::vector<std::uint8_t>& rgba) {
  std::string number = std::to_string(frames_);
  number.insert(0, names_.digits - std::min(names_.digits, number.size()), '0');
  Image picture{format_.width, format_.height, rgba};
  straighten(picture.rgba);
  write_png(folder_ / (names_.before + number + names_.after), picture, provenance_);
  ++frames_;
}

}  // namespace fascia
