// Finds the point under a pixel of a picture from the depth buffer: read without waiting, one picture late.
#pragma once
#include <Eigen/Core>
#include <optional>

#include "gl/buffer.h"
#include "gl/fence.h"
#include "render/target/framebuffer.h"

namespace fascia {

class DepthProbe {
 public:
  struct Spot {
    Eigen::Vector3d point, normal;  // [m]; unit length, towards the camera
  };

  DepthProbe() = default;
  ~DepthProbe();
  DepthProbe(const DepthProbe&) = delete;
  DepthProbe& operator=(const DepthProbe&) = delete;

  /// Queues a read around pixel (x, y) from the top left, in a picture drawn by this world-to-clip transform. The pixel
  /// must lie in the picture.
  void request(const Framebuffer& framebuffer, int x, int y, const Eigen::Matrix4d& to_clip);
  bool pending() const { return fence_.is_set(); }
  /// True if a request was answered; `spot` then holds the result, empty for a pixel without geometry.
  bool take(std::optional<Spot>& spot);

 private:
  static constexpr int kSize = 5;       // size of the square that is read [pixels]: enough for a normal
  GLuint framebuffer_ = 0, depth_ = 0;  // single-sampled, created at the first read of a multisampled picture
  gl::Buffer staging_;
  gl::Fence fence_;
  int width_ = 0, height_ = 0, left_ = 0, bottom_ = 0;
  Eigen::Matrix4d from_clip_;
};

}  // namespace fascia
