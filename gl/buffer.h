// A block of GPU memory: shader storage, uniform, index or vertex data. Move-only.
#pragma once
#include <cstddef>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "gl/barriers.h"
#include "gl/loader.h"

namespace fascia::gl {

class Buffer {
 public:
  Buffer() = default;
  /// Zero-filled when `data` is null. `label` shows in KHR_debug messages and in the statistics.
  Buffer(std::string label, std::size_t bytes, const void* data = nullptr)
      : Buffer(std::move(label), bytes, data, Memory::device) {}
  /// A buffer for copies that are read later, in memory that the CPU can read without waiting for the GPU's queue.
  static Buffer staging(std::string label, std::size_t bytes) {
    return {std::move(label), bytes, nullptr, Memory::host};
  }
  template <class T>
  Buffer(std::string label, const std::vector<T>& data)
      : Buffer(std::move(label), data.size() * sizeof(T), data.data()) {}
  ~Buffer();
  Buffer(Buffer&& other) noexcept;
  Buffer& operator=(Buffer&& other) noexcept;

  GLuint id() const { return id_; }
  std::size_t bytes() const { return bytes_; }
  const std::string& label() const { return label_; }
  explicit operator bool() const { return id_ != 0; }

  void upload(std::size_t offset, std::size_t bytes, const void* data);
  /// Waits for the GPU. On GPUs through a staging copy, which is kept: drivers move a buffer that is read directly to
  /// the host's memory, where kernels then have to fetch it.
  void download(std::size_t offset, std::size_t bytes, void* data) const;
  void clear();  // zeros
  /// Copies the first `bytes` of another buffer to `offset`, on the GPU.
  void copy(const Buffer& from, std::size_t bytes, std::size_t offset = 0) { copy(from, 0, bytes, offset); }
  void copy(const Buffer& from, std::size_t from_offset, std::size_t bytes, std::size_t offset);
  template <class T>
  std::vector<T> read() const {
    std::vector<T> data(bytes_ / sizeof(T));
    download(0, data.size() * sizeof(T), data.data());
    return data;
  }
  /// A buffer texture over the whole buffer (GL_RGBA32F, GL_R32UI, ...), created at the first call and kept. Throws
  /// Error if the buffer has more texels than the device can fetch.
  GLuint texel_view(GLenum internal_format) const;

  /// To be called before a draw that reads a buffer into which kernels store: makes the barrier `kind`, the bit of how
  /// it reads, if that is needed.
  void before_draw(GLbitfield kind) const;
  ShaderAccess& shader_access() const { return shader_access_; }

 private:
  enum class Memory { device, host };
  Buffer(std::string label, std::size_t bytes, const void* data, Memory memory);
  void after_stores() const;
  void upload_zeros(std::size_t bytes);
  void release();
  GLuint id_ = 0;
  std::size_t bytes_ = 0;
  std::string label_;
  Memory memory_ = Memory::device;
  mutable std::map<GLenum, GLuint> views_;
  mutable ShaderAccess shader_access_;
  mutable std::unique_ptr<Buffer> staging_;  // of downloads
};

/// Bytes of all existing Buffers and Textures, and those counted with count_bytes (renderbuffers).
std::size_t allocated_bytes();
/// Bytes of all existing Buffers by label.
const std::map<std::string, std::size_t>& bytes_by_buffer();
void count_bytes(std::ptrdiff_t change);

/// For the sized formats that fascia uses; throws Error for others.
std::size_t bytes_per_texel(GLenum internal_format);

}  // namespace fascia::gl
