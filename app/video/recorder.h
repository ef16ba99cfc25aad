// Writes video files: raw frames into an ffmpeg child process, under a temporary name until the last frame is written.
#pragma once
#include <sys/types.h>

#include "app/video/frame_sink.h"

namespace fascia {

class Recorder : public FrameSink {
 public:
  /// The extension of `path` selects the container (.mp4: H.264, .webm: VP9). Width and height must be even. Throws
  /// Error if ffmpeg is not installed.
  Recorder(std::filesystem::path path, const FrameFormat& format, const Provenance& provenance);
  ~Recorder() override;
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  /// Throws Error if ffmpeg ended, with its last line of output.
  void write(const std::vector<std::uint8_t>& rgba) override;
  /// Completes the video and renames it. Throws Error if ffmpeg failed.
  void finish() override;

 private:
  [[noreturn]] void fail(const std::string& what);
  int wait_for_child();
  void remove_files();  // temporary files

  std::filesystem::path path_, temporary_, log_, metadata_;
  std::size_t frame_bytes_;
  int pipe_ = -1;
  pid_t child_ = -1;
  long frames_ = 0;
};

}  // namespace fascia
