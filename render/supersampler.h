// Pictures with more samples per pixel than the renderer provides: drawn several times, each time shifted by a part of
// a pixel, and averaged.
#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "render/target/framebuffer.h"
#include "render/view/camera.h"

namespace fascia {

inline constexpr int kMostSamples = 256;  // per pixel: the largest number of bytes whose sum fits into 16 bits

/// Largest number of samples per pixel in one picture. Needs a current context.
int samples_of_renderer();

class Supersampler {
 public:
  /// Provides at least `samples` samples per pixel, up to kMostSamples. Throws Error.
  Supersampler(int width, int height, int samples);

  /// `draw_scene` draws into the framebuffer and resolves it. The result is the resolved average, over which panels can
  /// be drawn.
  Framebuffer& draw(Camera& camera, const std::function<void(Framebuffer&)>& draw_scene);
  Framebuffer& framebuffer() { return framebuffer_; }

 private:
  Framebuffer framebuffer_;
  int pictures_;  // number that is averaged
  std::vector<std::uint8_t> pixels_;
  std::vector<std::uint16_t> sums_;
};

}  // namespace fascia
