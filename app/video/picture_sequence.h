// A video as numbered PNG files, each with what made it.
#pragma once
#include <optional>
#include <string>

#include "app/video/frame_sink.h"

namespace fascia {

/// The file names of a sequence: what stands before and after the number, and how many digits that has at least.
struct PictureNames {
  std::string before, after;
  std::size_t digits = 0;
};
/// Of a pattern with one %d or %05d in its file name; nothing where it has none.
std::optional<PictureNames> picture_names(const std::filesystem::path& pattern);

class PictureSequence : public FrameSink {
 public:
  /// `pattern` as picture_names() takes it; its folder is made if it is missing. Throws Error.
  PictureSequence(std::filesystem::path pattern, const FrameFormat& format, Provenance provenance);
  void write(const std::vector<std::uint8_t>& rgba) override;
  void finish() override {}

 private:
  std::filesystem::path folder_;
  PictureNames names_;
  FrameFormat format_;
  Provenance provenance_;
  long frames_ = 0;
};

}  // namespace fascia
