#include "render/supersampler.h"

#include <algorithm>
#include <cmath>

namespace fascia {
namespace {

// The numbers 1, 2, 3... with their digits mirrored at the radix point: they fill 0 to 1 evenly (van der Corput 1935;
// Halton 1964).
double mirrored(int number, int base) {
  double value = 0, digit = 1.0 / base;
  for (; number > 0; number /= base, digit /= base) value += digit * (number % base);
  return value;
}

}  // namespace

int samples_of_renderer() {
  GLint most = 1;
  gl::GetIntegerv(GL_MAX_SAMPLES, &most);
  return std::max(most, 1);
}

Supersampler::Supersampler(int width, int height, int samples)
    : framebuffer_(width, height, std::min(samples, samples_of_renderer())),
      pictures_((samples + framebuffer_.samples() - 1) / framebuffer_.samples()) {}

Framebuffer& Supersampler::draw(Camera& camera, const std::function<void(Framebuffer&)>& draw_scene) {
  if (pictures_ == 1) {
    draw_scene(framebuffer_);
    return framebuffer_;
  }
  const double width = framebuffer_.width(), height = framebuffer_.height();
  // The renderer's own samples are spread over a pixel: a shift within the part that each represents fills the gaps.
  const double part = 1 / std::sqrt(static_cast<double>(framebuffer_.samples()));
  const std::size_t bytes =
      4 * static_cast<std::size_t>(framebuffer_.width()) * static_cast<std::size_t>(framebuffer_.height());
  pixels_.resize(bytes);
  sums_.assign(bytes, 0);
  for (int k = 1; k <= pictures_; ++k) {
    camera.jitter = 2 * part * Eigen::Vector2d((mirrored(k, 2) - 0.5) / width, (mirrored(k, 3) - 0.5) / height);
    draw_scene(framebuffer_);
    framebuffer_.read_into(pixels_.data());
    for (std::size_t i = 0; i < bytes; ++i) sums_[i] = static_cast<std::uint16_t>(sums_[i] + pixels_[i]);
  }
  camera.jitter.setZero();
  const auto count = static_cast<unsigned>(pictures_);
  for (std::size_t i = 0; i < bytes; ++i) pixels_[i] = static_cast<std::uint8_t>((sums_[i] + count / 2) / count);
  framebuffer_.replace(pixels_.data());
  return framebuffer_;
}

}  // namespace fascia
