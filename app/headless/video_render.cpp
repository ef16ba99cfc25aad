#include "app/headless/video_render.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "base/error.h"
#include "base/interrupt.h"
#include "sim/replay/replay_time.h"

namespace fascia {
namespace {

constexpr double kRounding = 1e-6;  // [frames], [steps] rounding of accumulated times

double longest_step(const Simulation& simulation) {
  return simulation.replay() ? ReplayTime(*simulation.replay()).longest_step() : simulation.scene.solver.time_step;
}

}  // namespace

VideoRender::VideoRender(const RenderOptions& options, Headless& headless)
    : options_(options),
      headless_(headless),
      rate_(options.fps * options.slow),
      pixels_(std::size_t{4} * static_cast<std::size_t>(options.width) * static_cast<std::size_t>(options.height)) {
  const Simulation& simulation = headless.session().simulation;
  if (rate_ * longest_step(simulation) > 1 + kRounding) interpolated_.emplace(simulation.replay());
  if (interpolated_ && !options.split.empty())
    throw Error("--split", "has no pictures between its steps",
                "expected at most a frame per step: fewer --fps, less --slow or a smaller solver.time_step");
  sink_ = open_frames(options.video, {options.width, options.height, options.fps}, headless.provenance());
}

void VideoRender::after_step() {
  const Simulation& simulation = headless_.session().simulation;
  const long step = headless_.step();
  frame_of_step_.push_back(rate_ * simulation.simulated());
  if (interpolated_) {
    headless_.show_as_of(static_cast<double>(step));  // the colors are stored with the positions
    interpolated_->add(step, headless_.session().simulation);
    headless_.remember_grabs();
  }
  if (step == headless_.steps()) return;  // finish() writes the remaining frames
  double end = frame_of_step_.back() + 0.5 * rate_ * simulation.scene.solver.time_step;
  if (interpolated_)
    end = step < InterpolatedFrames::kAhead
              ? 0
              : frame_of_step_[static_cast<std::size_t>(step - InterpolatedFrames::kAhead)];
  while (static_cast<double>(frame_) < end - kRounding) write_frame();
}

// The number of steps at the time of a frame, whole or fractional.
double VideoRender::step_at(double frame) const {
  const auto next = std::upper_bound(frame_of_step_.begin(), frame_of_step_.end(), frame + kRounding);
  const auto before = std::prev(next);
  const auto step = static_cast<double>(before - frame_of_step_.begin());
  if (next == frame_of_step_.end()) return step;
  const double part = (frame - *before) / (*next - *before);
  return step + (part < kRounding ? 0 : part);
}

void VideoRender::write_frame() {
  const double step = interpolated_ ? step_at(static_cast<double>(frame_)) : static_cast<double>(headless_.step());
  const double time = static_cast<double>(frame_) / rate_;
  headless_.draw(step, time, interpolated_ ? &interpolated_->at(step) : nullptr).read_into(pixels_.data());
  if (const Session& session = headless_.session();
      session.look.heat_map && !session.display().range && session.has_range()) {
    last_range_ = session.look.range;
    if (!first_range_ || std::exchange(ranged_, session.display().color) != session.display().color)
      first_range_ = last_range_;
  }
  sink_->write(pixels_);
  if (options_.hash) hash_.add(pixels_);
  ++frame_;
}

void VideoRender::finish(const Progress& progress) {
  const bool at_rest = frame_of_step_.empty();  // static equilibrium, around which the camera moves
  if (at_rest) interpolated_.reset();
  const double end = at_rest ? rate_ * headless_.camera_seconds() : frame_of_step_.back();
  const long frames = std::lround(end + kRounding);
  while (frame_ < frames && !(at_rest && interrupted())) {
    write_frame();
    if (at_rest) report(progress, static_cast<double>(frame_) / static_cast<double>(frames), "Writing frames");
  }
  sink_->finish();
}

std::string VideoRender::note_of_range() const {
  if (first_range_ == last_range_) return "";
  std::ostringstream text;
  text << "the range of the colors grew in the video; display.range=[" << last_range_->x() << ',' << last_range_->y()
       << "] gives it one range";
  return text.str();
}

}  // namespace fascia
