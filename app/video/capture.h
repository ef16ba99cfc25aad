// Pictures and videos out of the window, with what made them as metadata.
#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/video/frame_queue.h"
#include "app/video/video_settings.h"
#include "render/target/framebuffer.h"

namespace fascia {

/// A video at the speed of life: simulated time is its time, so that it stands still where the simulation does.
class VideoCapture {
 public:
  /// `window`: what it shows now. Throws Error, as all below do when ffmpeg or the disk fails; the video is gone then.
  void start(const VideoSettings& settings, const Framebuffer& window, const Provenance& provenance);
  std::filesystem::path finish();
  bool running() const { return queue_ != nullptr; }
  double seconds() const { return static_cast<double>(frames_) / settings_.fps; }  // of video so far
  long dropped() const { return dropped_; }  // frames for which the one before is shown, for there was no other
  const VideoSettings& settings() const { return settings_; }

  /// After `simulated` more seconds [s]: whether a frame is due.
  bool advance(double simulated);
  /// What to draw a due frame on: the window's picture where that is what is wanted, else one of its own.
  Framebuffer& canvas(Framebuffer& window, bool shows_panels);
  void write(const Framebuffer& canvas);

 private:
  VideoSettings settings_;
  std::unique_ptr<FrameQueue> queue_;
  std::unique_ptr<Framebuffer> own_;
  std::filesystem::path path_;
  VideoSettings::Size size_{};
  double owed_ = 0;  // frames
  long frames_ = 0, dropped_ = 0;
  std::vector<std::uint8_t> pixels_;
};

}  // namespace fascia
