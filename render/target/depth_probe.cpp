#include "render/target/depth_probe.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>

namespace fascia {

using Eigen::Vector3d;

DepthProbe::~DepthProbe() {
  gl::DeleteFramebuffers(1, &framebuffer_);
  gl::DeleteRenderbuffers(1, &depth_);
}

void DepthProbe::request(const Framebuffer& framebuffer, int x, int y, const Eigen::Matrix4d& to_clip) {
  if (fence_.is_set() || framebuffer.width() < kSize || framebuffer.height() < kSize) return;
  width_ = framebuffer.width();
  height_ = framebuffer.height();
  left_ = std::clamp(x - kSize / 2, 0, width_ - kSize);
  bottom_ = std::clamp(height_ - 1 - y - kSize / 2, 0, height_ - kSize);
  from_clip_ = to_clip.inverse();
  if (!staging_) staging_ = gl::Buffer::staging("depth_probe", kSize * kSize * sizeof(float));
  int read_left = left_, read_bottom = bottom_;
  gl::BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer.draw_id());
  if (framebuffer.samples() > 1) {
    if (!framebuffer_) {
      gl::GenRenderbuffers(1, &depth_);
      gl::BindRenderbuffer(GL_RENDERBUFFER, depth_);
      gl::RenderbufferStorageMultisample(GL_RENDERBUFFER, 0, GL_DEPTH24_STENCIL8, kSize, kSize);
      gl::GenFramebuffers(1, &framebuffer_);
      gl::BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_);
      gl::FramebufferRenderbuffer(GL_DRAW_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, depth_);
    }
    gl::BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_);
    gl::Disable(GL_SCISSOR_TEST);
    gl::BlitFramebuffer(left_, bottom_, left_ + kSize, bottom_ + kSize, 0, 0, kSize, kSize, GL_DEPTH_BUFFER_BIT,
                        GL_NEAREST);
    gl::BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
    read_left = read_bottom = 0;
  }
  gl::BindBuffer(GL_PIXEL_PACK_BUFFER, staging_.id());
  gl::ReadPixels(read_left, read_bottom, kSize, kSize, GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
  gl::BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  fence_.set();
}

bool DepthProbe::take(std::optional<Spot>& spot) {
  if (!fence_.take(false)) return false;
  std::array<float, kSize * kSize> depth{};
  staging_.download(0, sizeof depth, depth.data());
  spot.reset();
  const auto point = [&](int column, int row) {
    const double d = depth[static_cast<std::size_t>(kSize * row + column)];
    const Eigen::Vector4d p = from_clip_ * Eigen::Vector4d(2 * (left_ + column + 0.5) / width_ - 1,
                                                           2 * (bottom_ + row + 0.5) / height_ - 1, 2 * d - 1, 1);
    return Vector3d(p.head<3>() / p.w());
  };
  constexpr int kMiddle = kSize / 2, kLast = kSize - 1;
  const auto drawn = [&](int column, int row) { return depth[static_cast<std::size_t>(kSize * row + column)] < 1; };
  if (!drawn(kMiddle, kMiddle)) return true;
  const Vector3d middle = point(kMiddle, kMiddle), eye_ray = middle - [&] {
    const Eigen::Vector4d p = from_clip_ * Eigen::Vector4d(0, 0, -1, 1);  // on the near plane
    return Vector3d(p.head<3>() / p.w());
  }();
  Vector3d normal = -eye_ray;
  if (drawn(0, kMiddle) && drawn(kLast, kMiddle) && drawn(kMiddle, 0) && drawn(kMiddle, kLast))
    normal = (point(kLast, kMiddle) - point(0, kMiddle)).cross(point(kMiddle, kLast) - point(kMiddle, 0));
  if (!(normal.norm() > 0) || !normal.allFinite()) return true;
  normal.normalize();
  spot = Spot{middle, normal.dot(eye_ray) > 0 ? Vector3d(-normal) : normal};
  return true;
}

}  // namespace fascia
