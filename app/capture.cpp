#include "app/capture.h"

#include <algorithm>
#include <cmath>
#include <ctime>

namespace fascia {
namespace fs = std::filesystem;

fs::path dated_name(const std::string& ending) {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  char stamp[32];
  std::strftime(stamp, sizeof stamp, "%Y%m%d-%H%M%S", &local);
  const std::string stem = std::string("fascia-") + stamp;
  fs::path path = stem + ending;
  std::error_code ec;
  for (int n = 2; fs::exists(path, ec); ++n) path = stem + "-" + std::to_string(n) + ending;
  return path;
}

void VideoCapture::start(const Framebuffer& framebuffer, const Provenance& provenance) {
  path_ = dated_name(".mp4");
  width_ = framebuffer.width();
  height_ = framebuffer.height();
  owed_ = 1;
  // H.264 wants even sizes; a window has any size.
  recorder_ = std::make_unique<Recorder>(path_, width_ & ~1, height_ & ~1, kFps, provenance);
}

fs::path VideoCapture::finish() {
  const std::unique_ptr<Recorder> recorder = std::move(recorder_);
  recorder->finish();
  return path_;
}

double VideoCapture::seconds() const { return recorder_ ? static_cast<double>(recorder_->frames()) / kFps : 0; }

int VideoCapture::steps_per_frame(double time_step) {
  return std::max(1, static_cast<int>(std::lround(1 / (kFps * time_step))));
}

void VideoCapture::write(const Framebuffer& framebuffer, double simulated) {
  owed_ += simulated * kFps;
  if (owed_ < 0.5) return;
  const std::size_t row = 4 * static_cast<std::size_t>(width_), even_row = 4 * static_cast<std::size_t>(width_ & ~1);
  const auto even_height = static_cast<std::size_t>(height_ & ~1);
  pixels_.resize(row * static_cast<std::size_t>(height_));
  framebuffer.read_into(pixels_.data());
  even_.resize(even_row * even_height);
  for (std::size_t y = 0; y < even_height; ++y)
    std::copy_n(pixels_.begin() + static_cast<std::ptrdiff_t>(y * row), even_row, even_.begin() + static_cast<std::ptrdiff_t>(y * even_row));
  try {
    for (; owed_ >= 0.5; owed_ -= 1) recorder_->write(even_);
  } catch (...) {
    recorder_.reset();
    throw;
  }
}

}  // namespace fascia
