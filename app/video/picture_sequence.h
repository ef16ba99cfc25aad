// A video as numbered PNG files, each with its provenance.
#pragma once
#include <optional>
#include <string>

#include "app/video/frame_sink.h"

namespace fascia {

/// The file names of a sequence: the parts before and after the number, and its smallest number of digits.
struct PictureNames {
  std::string before, after;
  std::size_t digits = 0;
};
/// Parses a pattern with one %d or %05d in its file name; none for other names.
std::optional<PictureNames> picture_names(const std::filesystem::path& pattern);

class PictureSequence : public FrameSink {
 public:
  /// `pattern` as in picture_names(); its folder is created if it is missing. Throws Error.
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
