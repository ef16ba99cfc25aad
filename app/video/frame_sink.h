// The destination of a video's frames: a file through ffmpeg, or one picture each.
#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "sim/output/run_provenance.h"

namespace fascia {

class FrameSink {
 public:
  virtual ~FrameSink() = default;  // without finish(): incomplete files are removed
  /// One frame, [4 * width * height] RGBA, top row first. Throws Error.
  virtual void write(const std::vector<std::uint8_t>& rgba) = 0;
  /// Completes all files. Throws Error.
  virtual void finish() = 0;
};

struct FrameFormat {
  int width, height;
  double fps;
  bool live = false;  // an encoder that is fast enough for a window, at the price of larger files
};

/// Throws UsageError that names `option` for a path that open_frames() cannot write, and Error for a missing folder:
/// called before long work.
void require_frames(const std::string& option, const std::filesystem::path& path);

/// A path with a placeholder for the number, as frames/%05d.png, is a sequence of pictures from 0 on; any other
/// extension selects a video's container (.mp4, .webm, .gif and others that ffmpeg supports). Throws Error.
std::unique_ptr<FrameSink> open_frames(const std::filesystem::path& path, const FrameFormat& format,
                                       const Provenance& provenance);

}  // namespace fascia
