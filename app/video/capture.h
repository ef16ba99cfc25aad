// Pictures and videos of the window, with their provenance as metadata.
#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/video/frame_queue.h"
#include "app/video/video_settings.h"
#include "render/target/framebuffer.h"

namespace fascia {

/// A video in real time: its time is the simulated time, so that it stands still while the simulation does.
class VideoCapture {
 public:
  /// `window`: its current picture. Throws Error, as all functions below do if ffmpeg or the disk fails; the video is
  /// then removed.
  void start(const VideoSettings& settings, const Framebuffer& window, const Provenance& provenance);
  std::filesystem::path finish();
  bool running() const { return queue_ != nullptr; }
  double seconds() const { return static_cast<double>(frames_) / settings_.fps; }  // of video so far
  long dropped() const { return dropped_; }  // frames that repeat the previous picture because no new one was available
  const VideoSettings& settings() const { return settings_; }

  /// Advances by `simulated` seconds [s]; returns whether a frame is due.
  bool advance(double simulated);
  /// The framebuffer for a due frame: the window's picture if that shows what was requested in full quality, else a
  /// separate one.
  Framebuffer& canvas(Framebuffer& window, bool shows_panels, bool full_quality);
  void write(const Framebuffer& canvas);

 private:
  VideoSettings settings_;
  std::unique_ptr<FrameQueue> queue_;
  std::unique_ptr<Framebuffer> own_;
  std::filesystem::path path_;
  VideoSettings::Size size_{};
  double owed_ = 0;  // frames due
  long frames_ = 0, dropped_ = 0;
  std::vector<std::uint8_t> pixels_;
};

}  // namespace fascia
