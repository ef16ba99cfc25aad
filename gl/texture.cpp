#include "gl/texture.h"

#include <algorithm>
#include <utility>

#include "base/error.h"
#include "gl/buffer.h"

namespace fascia::gl {

Texture::Texture(std::string label, GLenum internal_format, int width, int height, int samples, GLenum format,
                 GLenum type, const void* pixels)
    : target_(samples > 0 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D), width_(width), height_(height) {
  const auto fail = [&] {
    throw Error("texture " + label,
                "cannot have " + std::to_string(width) + " x " + std::to_string(height) + " texels with " +
                    std::to_string(samples) + " samples",
                "expected a size and sample count that " + device().renderer + " has room for");
  };
  // Queried first: llvmpipe crashes on sizes far beyond its limit instead of refusing them.
  GLint most = 0;
  GetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
  if (width < 1 || height < 1 || width > most || height > most) fail();
  forget_errors();
  GenTextures(1, &id_);
  BindTexture(target_, id_);
  if (samples > 0) {
    TexImage2DMultisample(target_, samples, internal_format, width, height, GL_TRUE);
  } else {
    if (internal_format == GL_DEPTH_COMPONENT32F) format = GL_DEPTH_COMPONENT, type = GL_FLOAT;
    if (internal_format == GL_DEPTH24_STENCIL8) format = GL_DEPTH_STENCIL, type = GL_UNSIGNED_INT_24_8;
    PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    TexImage2D(target_, 0, static_cast<GLint>(internal_format), width, height, 0, format, type, pixels);
    TexParameteri(target_, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    TexParameteri(target_, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    TexParameteri(target_, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    TexParameteri(target_, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  }
  if (GetError() != GL_NO_ERROR) {
    DeleteTextures(1, &id_);
    fail();
  }
  ObjectLabel(GL_TEXTURE, id_, static_cast<GLsizei>(std::min<std::size_t>(label.size(), 100)), label.c_str());
  bytes_ = bytes_per_texel(internal_format) * static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
           static_cast<std::size_t>(std::max(samples, 1));
  count_bytes(static_cast<std::ptrdiff_t>(bytes_));
}

Texture::~Texture() { release(); }

Texture::Texture(Texture&& other) noexcept { *this = std::move(other); }

Texture& Texture::operator=(Texture&& other) noexcept {
  if (this == &other) return *this;
  release();
  id_ = std::exchange(other.id_, 0);
  target_ = other.target_;
  width_ = std::exchange(other.width_, 0);
  height_ = std::exchange(other.height_, 0);
  bytes_ = std::exchange(other.bytes_, 0);
  return *this;
}

void Texture::release() {
  if (!id_) return;
  DeleteTextures(1, &id_);
  count_bytes(-static_cast<std::ptrdiff_t>(bytes_));
  id_ = 0;
  bytes_ = 0;
}

GLuint make_target(GLenum attachment, const Texture& texture) {
  GLuint id = 0;
  GenFramebuffers(1, &id);
  BindFramebuffer(GL_FRAMEBUFFER, id);
  FramebufferTexture2D(GL_FRAMEBUFFER, attachment, texture.target(), texture.id(), 0);
  if (attachment != GL_COLOR_ATTACHMENT0) {
    DrawBuffer(GL_NONE);
    ReadBuffer(GL_NONE);
  }
  return id;
}

}  // namespace fascia::gl
