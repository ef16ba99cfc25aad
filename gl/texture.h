// A 2D texture or multisample texture. Move-only.
#pragma once
#include <string>

#include "gl/loader.h"

namespace fascia::gl {

class Texture {
 public:
  Texture() = default;
  /// samples 0: GL_TEXTURE_2D with linear filtering, clamped; else GL_TEXTURE_2D_MULTISAMPLE. `pixels` in
  /// `format`/`type`.
  Texture(std::string label, GLenum internal_format, int width, int height, int samples = 0, GLenum format = GL_RGBA,
          GLenum type = GL_UNSIGNED_BYTE, const void* pixels = nullptr);
  ~Texture();
  Texture(Texture&& other) noexcept;
  Texture& operator=(Texture&& other) noexcept;

  GLuint id() const { return id_; }
  GLenum target() const { return target_; }
  int width() const { return width_; }
  int height() const { return height_; }

 private:
  void release();
  GLuint id_ = 0;
  GLenum target_ = GL_TEXTURE_2D;
  int width_ = 0, height_ = 0;
  std::size_t bytes_ = 0;
};

/// A framebuffer object that draws into this texture only, as color, depth or depth and stencil; it stays bound.
GLuint make_target(GLenum attachment, const Texture& texture);

}  // namespace fascia::gl
