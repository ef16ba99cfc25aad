// Writes the frames of a video of a scene that runs without a window.
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/headless/headless.h"
#include "app/headless/interpolated_frames.h"
#include "app/video/frame_sink.h"
#include "base/byte_hash.h"
#include "base/progress.h"

namespace fascia {

class VideoRender {
 public:
  /// Frames are written to `options.video`. The video runs in real time, or slower by the requested factor, for any
  /// time step, even if a replay changes it: if there are more steps than frames, a frame shows the nearest step, else
  /// the positions are interpolated (InterpolatedFrames). Throws Error.
  VideoRender(const RenderOptions& options, Headless& headless);

  void after_step();  // writes the frames that can be drawn so far. Throws Error
  /// Writes all remaining frames; without steps, those of the camera's own motion.
  void finish(const Progress& progress = {});
  /// How to give the whole video one range of colors, if its automatic range grew; empty otherwise.
  std::string note_of_range() const;
  long frames() const { return frame_; }
  std::uint64_t hash() const { return hash_.value(); }  // of all frames

 private:
  void write_frame();
  double step_at(double frame) const;

  const RenderOptions& options_;
  Headless& headless_;
  double rate_;                        // frames per simulated second
  std::vector<double> frame_of_step_;  // times of the steps in frames [steps made + 1]
  std::optional<InterpolatedFrames> interpolated_;
  std::unique_ptr<FrameSink> sink_;
  std::vector<std::uint8_t> pixels_;
  ByteHash hash_;
  long frame_ = 0;
  ColorBy ranged_ = ColorBy::none;
  std::optional<Eigen::Vector2f> first_range_, last_range_;  // of a heat map that follows its values
};

}  // namespace fascia
