// Pictures and videos out of the window, as it shows them, with what made them as metadata.
#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/recorder.h"
#include "render/framebuffer.h"

namespace fascia {

/// fascia-20250131-235959.png in the current folder; numbered if there is one of the same second.
std::filesystem::path dated_name(const std::string& ending);

class VideoCapture {
 public:
  static constexpr double kFps = 60;

  /// Throws Error, as all below do when ffmpeg fails; the video is gone then.
  void start(const Framebuffer& framebuffer, const Provenance& provenance);
  std::filesystem::path finish();
  bool running() const { return recorder_ != nullptr; }
  double seconds() const;  // of video so far

  /// Most steps before the next picture, so that no frame of the video is left out.
  static int steps_per_frame(double time_step);
  /// After `simulated` more seconds [s]: writes the frames that are due, so that the video runs at the speed of life.
  void write(const Framebuffer& framebuffer, double simulated);
  bool fits(int width, int height) const { return width == width_ && height == height_; }

 private:
  std::unique_ptr<Recorder> recorder_;
  std::filesystem::path path_;
  int width_ = 0, height_ = 0;
  double owed_ = 0;  // frames
  std::vector<std::uint8_t> pixels_, even_;
};

}  // namespace fascia
