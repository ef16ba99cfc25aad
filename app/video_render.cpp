#include "app/video_render.h"

#include <cmath>

namespace fascia {

VideoRender::VideoRender(const RenderOptions& options, Headless& headless)
    : options_(options),
      headless_(headless),
      steps_per_frame_(1 / (options.fps * options.slow * headless.session().simulation.scene.solver.time_step)),
      sink_(open_frames(options.video, {options.width, options.height, options.fps}, headless.provenance())),
      pixels_(std::size_t{4} * static_cast<std::size_t>(options.width) * static_cast<std::size_t>(options.height)) {
  constexpr double kRounding = 1e-6;  // of a frame that lasts as long as a step
  if (steps_per_frame_ < 1 - kRounding) moments_.emplace(headless.session().simulation.replay());
}

void VideoRender::after_step() {
  const long step = headless_.step();
  if (moments_) {
    moments_->add(step, headless_.session().simulation);
    headless_.remember_hands();
  }
  if (step == headless_.steps()) return;  // finish() knows how many are left
  write_until(static_cast<double>(step) + (moments_ ? -Moments::kAhead : 0.5), false);
}

// Frames before that moment; with `whole` all of the video.
void VideoRender::write_until(double step, bool whole) {
  const long frames = std::lround(static_cast<double>(headless_.step()) / steps_per_frame_);
  for (double at = 0; at = static_cast<double>(frame_) * steps_per_frame_, whole ? frame_ < frames : at < step; ++frame_) {
    const double seen = moments_ ? at : static_cast<double>(headless_.step());
    headless_.draw(seen, moments_ ? &moments_->at(at) : nullptr).read_into(pixels_.data());
    sink_->write(pixels_);
    if (options_.hash) hash_.add(pixels_);
  }
}

void VideoRender::finish() {
  write_until(0, true);
  sink_->finish();
}

}  // namespace fascia
