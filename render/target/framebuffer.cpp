#include "render/target/framebuffer.h"

#include <algorithm>

#include "base/error.h"
#include "gl/buffer.h"

namespace fascia {
namespace {

constexpr std::ptrdiff_t kBytesPerSample = 4;  // of GL_RGBA8 and of GL_DEPTH24_STENCIL8 alike

void check_limit(const char* what, int value, int least, GLenum limit) {
  GLint most = 0;
  gl::GetIntegerv(limit, &most);
  if (value < least || value > most)
    throw Error("framebuffer", std::string(what) + " " + std::to_string(value),
                "expected " + std::to_string(least) + " to " + std::to_string(most));
}

}  // namespace

Framebuffer::Framebuffer(int width, int height, int samples)
    : width_(width), height_(height), samples_(std::max(samples, 1)) {
  check_limit("width", width, 1, GL_MAX_RENDERBUFFER_SIZE);
  check_limit("height", height, 1, GL_MAX_RENDERBUFFER_SIZE);
  check_limit("samples", samples, 0, GL_MAX_SAMPLES);
  resolved_color_ = gl::Texture("framebuffer color", GL_RGBA8, width, height);

  const auto renderbuffer = [&](GLuint& id, GLenum format, GLenum attachment) {
    gl::GenRenderbuffers(1, &id);
    gl::BindRenderbuffer(GL_RENDERBUFFER, id);
    gl::RenderbufferStorageMultisample(GL_RENDERBUFFER, samples_ > 1 ? samples_ : 0, format, width, height);
    gl::FramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, id);
    renderbuffer_bytes_ += kBytesPerSample * width * height * samples_;
  };
  const auto color_texture = [&] {
    gl::FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, resolved_color_.id(), 0);
  };
  gl::GenFramebuffers(1, &resolved_);
  gl::BindFramebuffer(GL_FRAMEBUFFER, resolved_);
  color_texture();
  GLenum status = gl::CheckFramebufferStatus(GL_FRAMEBUFFER);
  gl::GenFramebuffers(1, &draw_);
  gl::BindFramebuffer(GL_FRAMEBUFFER, draw_);
  renderbuffer(depth_, GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL_ATTACHMENT);
  if (samples_ > 1)
    renderbuffer(color_, GL_RGBA8, GL_COLOR_ATTACHMENT0);
  else
    color_texture();
  gl::count_bytes(renderbuffer_bytes_);
  if (status == GL_FRAMEBUFFER_COMPLETE) status = gl::CheckFramebufferStatus(GL_FRAMEBUFFER);
  if (status == GL_FRAMEBUFFER_COMPLETE) return;
  release();
  throw Error("framebuffer",
              "incomplete (status " + std::to_string(status) + ") at " + std::to_string(width) + " x " +
                  std::to_string(height) + " with " + std::to_string(samples_) + " samples",
              "expected a size and sample count that " + gl::device().renderer + " can draw");
}

Framebuffer::~Framebuffer() { release(); }

void Framebuffer::release() {
  const GLuint framebuffers[] = {draw_, resolved_}, renderbuffers[] = {color_, depth_};  // zeros are ignored
  gl::DeleteFramebuffers(2, framebuffers);
  gl::DeleteRenderbuffers(2, renderbuffers);
  gl::count_bytes(-renderbuffer_bytes_);
}

void Framebuffer::bind() const {
  gl::BindFramebuffer(GL_FRAMEBUFFER, draw_);
  gl::Viewport(0, 0, width_, height_);
}

void Framebuffer::resolve() const {
  if (samples_ == 1) return;  // already drawn into the resolved picture
  gl::BindFramebuffer(GL_READ_FRAMEBUFFER, draw_);
  gl::BindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_);
  gl::Disable(GL_SCISSOR_TEST);  // it would clip the blit
  gl::BlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void Framebuffer::bind_resolved() const {
  gl::BindFramebuffer(GL_FRAMEBUFFER, resolved_);
  gl::Viewport(0, 0, width_, height_);
}

Image Framebuffer::read() const {
  Image image{width_, height_, {}};
  image.rgba.resize(4 * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  read_into(image.rgba.data());
  straighten(image.rgba);
  return image;
}

void Framebuffer::read_into(std::uint8_t* rgba) const {
  gl::BindFramebuffer(GL_READ_FRAMEBUFFER, resolved_);
  gl::ReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
  const auto row = 4 * static_cast<std::size_t>(width_);  // converts from OpenGL's bottom row first to top row first
  for (std::size_t top = 0, bottom = static_cast<std::size_t>(height_) - 1; top < bottom; ++top, --bottom)
    std::swap_ranges(rgba + top * row, rgba + (top + 1) * row, rgba + bottom * row);
}

void Framebuffer::replace(const std::uint8_t* rgba) {
  const auto row = 4 * static_cast<std::size_t>(width_);
  gl::BindTexture(GL_TEXTURE_2D, resolved_color_.id());
  for (int y = 0; y < height_; ++y)
    gl::TexSubImage2D(GL_TEXTURE_2D, 0, 0, height_ - 1 - y, width_, 1, GL_RGBA, GL_UNSIGNED_BYTE,
                      rgba + static_cast<std::size_t>(y) * row);
}

void Framebuffer::copy_to(const Framebuffer& target, int x) const {
  gl::BindFramebuffer(GL_READ_FRAMEBUFFER, resolved_);
  gl::BindFramebuffer(GL_DRAW_FRAMEBUFFER, target.resolved_);
  gl::Disable(GL_SCISSOR_TEST);  // it would clip the blit
  gl::BlitFramebuffer(0, 0, width_, height_, x, 0, x + width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void Framebuffer::present(int window_width, int window_height) const {
  const bool same = window_width == width_ && window_height == height_;
  gl::BindFramebuffer(GL_READ_FRAMEBUFFER, resolved_);
  gl::BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  gl::Disable(GL_SCISSOR_TEST);
  gl::BlitFramebuffer(0, 0, width_, height_, 0, 0, window_width, window_height, GL_COLOR_BUFFER_BIT,
                      same ? GL_NEAREST : GL_LINEAR);
}

}  // namespace fascia
