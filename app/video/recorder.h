// Video files: raw frames into an ffmpeg child process, under a temporary name until the last frame is written.
#pragma once
#include <sys/types.h>

#include "app/video/frame_sink.h"

namespace fascia {

class Recorder : public FrameSink {
 public:
  /// `path` ending decides the container (.mp4: H.264, .webm: VP9). Width and height must be even. Throws Error when
  /// ffmpeg is not installed.
  Recorder(std::filesystem::path path, const FrameFormat& format, const Provenance& provenance);
  ~Recorder() override;
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  /// Throws Error when ffmpeg died, with what it said last.
  void write(const std::vector<std::uint8_t>& rgba) override;
  /// Closes the video and puts it under its name. Throws Error when ffmpeg failed.
  void finish() override;

 private:
  [[noreturn]] void fail(const std::string& what);
  int wait_for_child();
  void remove_files();  // that are not the video

  std::filesystem::path path_, temporary_, log_, metadata_;
  std::size_t frame_bytes_;
  int pipe_ = -1;
  pid_t child_ = -1;
  long frames_ = 0;
};

}  // namespace fascia
