#include "app/video/capture.h"

#include <algorithm>
#include <cmath>

#include "base/dated_name.h"

namespace fascia {
namespace fs = std::filesystem;

void VideoCapture::start(const VideoSettings& settings, const Framebuffer& window, const Provenance& provenance) {
  size_ = settings.size_in({window.width(), window.height()});
  fs::path path = dated_name(settings.kind == VideoKind::mp4    ? ".mp4"
                             : settings.kind == VideoKind::webm ? ".webm"
                                                                : "");
  const fs::path target = settings.kind == VideoKind::pictures ? path / "%05d.png" : path;
  queue_ =
      std::make_unique<FrameQueue>(open_frames(target, {size_.width, size_.height, settings.fps, true}, provenance));
  path_ = std::move(path);
  settings_ = settings;
  owed_ = 1;
  frames_ = dropped_ = 0;
}

fs::path VideoCapture::finish() {
  const std::unique_ptr<FrameQueue> queue = std::move(queue_);
  own_.reset();
  queue->finish();
  return path_;
}

bool VideoCapture::advance(double simulated) {
  owed_ += simulated * settings_.fps;
  return owed_ >= 0.5;
}

Framebuffer& VideoCapture::canvas(Framebuffer& window, bool shows_panels, bool full_quality) {
  const VideoSettings::Size whole = settings_.size_in({window.width(), window.height()});
  const bool same_size = settings_.width == 0 ? whole.width == size_.width && whole.height == size_.height
                                              : window.width() == size_.width && window.height() == size_.height;
  if (full_quality && same_size && (settings_.panels || !shows_panels)) return window;
  if (!own_) own_ = std::make_unique<Framebuffer>(size_.width, size_.height, window.samples());
  return *own_;
}

void VideoCapture::write(const Framebuffer& canvas) {
  const std::size_t row = 4 * static_cast<std::size_t>(canvas.width()),
                    own_row = 4 * static_cast<std::size_t>(size_.width);
  pixels_.resize(row * static_cast<std::size_t>(canvas.height()));
  canvas.read_into(pixels_.data());
  std::vector<std::uint8_t> frame(own_row * static_cast<std::size_t>(size_.height));
  for (std::size_t y = 0; y < static_cast<std::size_t>(size_.height); ++y)
    std::copy_n(pixels_.begin() + static_cast<std::ptrdiff_t>(y * row), own_row,
                frame.begin() + static_cast<std::ptrdiff_t>(y * own_row));
  const int count = static_cast<int>(std::floor(owed_ + 0.5));
  owed_ -= count;
  try {
    dropped_ += queue_->add(std::move(frame), count);
  } catch (...) {
    queue_.reset();
    own_.reset();
    throw;
  }
  frames_ += count;
}

}  // namespace fascia
