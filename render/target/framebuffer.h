// The target of all drawing: color, depth and stencil, multisampled on request, resolved for reading or display.
#pragma once
#include <cstddef>

#include "gl/texture.h"
#include "render/target/image.h"

namespace fascia {

class Framebuffer {
 public:
  Framebuffer(int width, int height, int samples);  // samples 0 or 1: none. Throws Error.
  ~Framebuffer();
  Framebuffer(const Framebuffer&) = delete;
  Framebuffer& operator=(const Framebuffer&) = delete;

  int width() const { return width_; }
  int height() const { return height_; }
  int samples() const { return samples_; }
  void bind() const;                        // for drawing, viewport set
  GLuint draw_id() const { return draw_; }  // the framebuffer that bind() binds
  void resolve() const;                     // multisample to single; bind_resolved() then draws over it (panels)
  void bind_resolved() const;
  Image read() const;                        // resolved picture with straight alpha, as files need it
  void read_into(std::uint8_t* rgba) const;  // [4 * width * height], top row first, no allocation; premultiplied
  void replace(const std::uint8_t* rgba);    // replaces the resolved picture by pixels in the format of read_into
  void copy_to(const Framebuffer& target,
               int x) const;                                // the resolved picture, into a wider one of the same height
  void present(int window_width, int window_height) const;  // blit to the window's framebuffer

 private:
  void release();
  int width_, height_, samples_;
  GLuint draw_ = 0, resolved_ = 0, color_ = 0, depth_ = 0;
  std::ptrdiff_t renderbuffer_bytes_ = 0;
  gl::Texture resolved_color_;
};

}  // namespace fascia
