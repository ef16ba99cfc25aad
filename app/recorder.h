// Video files: raw frames into an ffmpeg child process, under a temporary name until the last frame is written.
#pragma once
#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <vector>

#include "app/provenance.h"

namespace fascia {

class Recorder {
 public:
  /// `path` ending decides the container (.mp4: H.264). Width and height must be even. Throws Error when ffmpeg is not installed.
  Recorder(std::filesystem::path path, int width, int height, double fps, const Provenance& provenance);
  ~Recorder();  // without finish(): the unfinished file is removed
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  /// One frame, [4 * width * height] RGBA, top row first. Throws Error when ffmpeg died, with what it said last.
  void write(const std::vector<std::uint8_t>& rgba);
  /// Closes the video and puts it under its name. Throws Error when ffmpeg failed.
  void finish();
  long frames() const { return frames_; }

 private:
  [[noreturn]] void fail(const std::string& what);
  int wait_for_child();

  std::filesystem::path path_, temporary_, log_;
  std::size_t frame_bytes_;
  int pipe_ = -1;
  pid_t child_ = -1;
  long frames_ = 0;
};

}  // namespace fascia
