// A video as numbered PNG files, each with what made it.
#pragma once
#include <string>

#include "app/frame_sink.h"

namespace fascia {

class PictureSequence : public FrameSink {
 public:
  /// `pattern` has one %d or %05d in its file name; its folder is made if it is missing. Throws Error.
  PictureSequence(std::filesystem::path pattern, const FrameFormat& format, Provenance provenance);
  void write(const std::vector<std::uint8_t>& rgba) override;
  void finish() override {}

 private:
  std::filesystem::path folder_;
  std::string before_, after_;  // the number, in a file's name
  std::size_t digits_ = 0;      // at least
  FrameFormat format_;
  Provenance provenance_;
  long frames_ = 0;
};

}  // namespace fascia
