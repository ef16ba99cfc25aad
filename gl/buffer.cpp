#include "gl/buffer.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "base/error.h"
#include "gl/bindings.h"

namespace fascia::gl {
namespace {

std::size_t bytes_alive = 0;
std::map<std::string, std::size_t> bytes_by_label;

void count_buffer(const std::string& label, std::size_t bytes, bool is_new) {
  count_bytes(is_new ? static_cast<std::ptrdiff_t>(bytes) : -static_cast<std::ptrdiff_t>(bytes));
  if (is_new)
    bytes_by_label[label] += bytes;
  else if ((bytes_by_label[label] -= bytes) == 0)
    bytes_by_label.erase(label);
}

// An empty buffer still gets one vec4 of storage, so that it can be bound and viewed.
constexpr std::size_t kLeastBytes = 16;

}  // namespace

std::size_t allocated_bytes() { return bytes_alive; }
const std::map<std::string, std::size_t>& bytes_by_buffer() { return bytes_by_label; }
void count_bytes(std::ptrdiff_t change) { bytes_alive += static_cast<std::size_t>(change); }

std::size_t bytes_per_texel(GLenum internal_format) {
  switch (internal_format) {
    case GL_R8:
      return 1;
    case GL_R32F:
    case GL_R32I:
    case GL_R32UI:
    case GL_RGBA8:
    case GL_SRGB8_ALPHA8:
    case GL_DEPTH24_STENCIL8:
    case GL_DEPTH_COMPONENT32F:
      return 4;
    case GL_RGBA16F:
      return 8;
    case GL_RGBA32F:
    case GL_RGBA32UI:
      return 16;
    default:
      throw Error("texel format " + std::to_string(internal_format), "unknown",
                  "expected a sized format of bytes_per_texel");
  }
}

Buffer::Buffer(std::string label, std::size_t bytes, const void* data, Memory memory)
    : bytes_(bytes), label_(std::move(label)), memory_(memory) {
  forget_errors();
  GenBuffers(1, &id_);
  BindBuffer(GL_COPY_WRITE_BUFFER, id_);
  const std::size_t size = std::max(bytes, kLeastBytes);
  const bool whole = data && bytes == size, host = memory == Memory::host;
  if (BufferStorage)
    BufferStorage(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(size), whole ? data : nullptr,
                  host ? GL_MAP_READ_BIT | GL_CLIENT_STORAGE_BIT | GL_DYNAMIC_STORAGE_BIT : GL_DYNAMIC_STORAGE_BIT);
  else
    BufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(size), whole ? data : nullptr,
               host ? GL_STREAM_READ : GL_DYNAMIC_COPY);
  if (GetError() != GL_NO_ERROR) {
    DeleteBuffers(1, &id_);
    require_context();
    throw Error("buffer " + label_, "cannot have " + std::to_string(bytes) + " bytes",
                "expected room on " + device().renderer);
  }
  if (!whole) upload_zeros(size);
  if (data && !whole) upload(0, bytes, data);
  ObjectLabel(GL_BUFFER, id_, static_cast<GLsizei>(std::min<std::size_t>(label_.size(), 100)), label_.c_str());
  count_buffer(label_, bytes_, true);
}

Buffer::~Buffer() { release(); }

Buffer::Buffer(Buffer&& other) noexcept { *this = std::move(other); }

Buffer& Buffer::operator=(Buffer&& other) noexcept {
  if (this == &other) return *this;
  release();
  id_ = std::exchange(other.id_, 0);
  bytes_ = std::exchange(other.bytes_, 0);
  label_ = std::move(other.label_);
  memory_ = other.memory_;
  views_ = std::exchange(other.views_, {});
  shader_access_ = other.shader_access_;
  staging_ = std::move(other.staging_);
  return *this;
}

void Buffer::release() {
  if (!id_) return;
  for (const auto& [format, view] : views_) DeleteTextures(1, &view);
  forget_bindings_of(id_);
  DeleteBuffers(1, &id_);
  count_buffer(label_, bytes_, false);
  views_.clear();
  staging_.reset();
  id_ = 0;
  bytes_ = 0;
}

// Before reads and writes that are no shader's.
void Buffer::after_stores() const { make_barrier(shader_access_.missing(GL_BUFFER_UPDATE_BARRIER_BIT)); }

void Buffer::before_draw(GLbitfield kind) const {
  make_barrier(shader_access_.missing(kind));
  shader_access_.read_by(next_command());
}

void Buffer::upload(std::size_t offset, std::size_t bytes, const void* data) {
  assert(offset + bytes <= bytes_);
  if (bytes == 0) return;
  after_stores();
  BindBuffer(GL_COPY_WRITE_BUFFER, id_);
  BufferSubData(GL_COPY_WRITE_BUFFER, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes), data);
}

// Not by glClearBufferData: NVIDIA's driver (580) lets an upload of half a megabyte overtake it.
void Buffer::upload_zeros(std::size_t bytes) {
  static const std::vector<std::byte> zeros(std::size_t{1} << 20);
  after_stores();
  BindBuffer(GL_COPY_WRITE_BUFFER, id_);
  for (std::size_t begin = 0; begin < bytes; begin += zeros.size())
    BufferSubData(GL_COPY_WRITE_BUFFER, static_cast<GLintptr>(begin),
                  static_cast<GLsizeiptr>(std::min(zeros.size(), bytes - begin)), zeros.data());
}

void Buffer::clear() { upload_zeros(bytes_); }

void Buffer::copy(const Buffer& from, std::size_t from_offset, std::size_t bytes, std::size_t offset) {
  assert(offset + bytes <= bytes_ && from_offset + bytes <= from.bytes_);
  if (bytes == 0) return;
  from.after_stores();
  after_stores();
  BindBuffer(GL_COPY_READ_BUFFER, from.id_);
  BindBuffer(GL_COPY_WRITE_BUFFER, id_);
  CopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, static_cast<GLintptr>(from_offset),
                    static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes));
}

void Buffer::download(std::size_t offset, std::size_t bytes, void* data) const {
  assert(offset + bytes <= bytes_);
  if (bytes == 0) return;
  const Buffer* read = this;
  if (memory_ == Memory::device && !gl::device().software) {
    if (!staging_ || staging_->bytes() < bytes)
      staging_ = std::make_unique<Buffer>(staging(label_ + "_staging", bytes));
    staging_->copy(*this, offset, bytes, 0);
    read = staging_.get();
    offset = 0;
  }
  read->after_stores();
  BindBuffer(GL_COPY_READ_BUFFER, read->id_);
  GetBufferSubData(GL_COPY_READ_BUFFER, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes), data);
}

GLuint Buffer::texel_view(GLenum internal_format) const {
  if (const auto found = views_.find(internal_format); found != views_.end()) return found->second;
  const std::size_t texels = bytes_ / bytes_per_texel(internal_format);
  if (texels > static_cast<std::size_t>(device().max_texture_buffer_size))
    throw Error("buffer " + label_, "has " + std::to_string(texels) + " texels",
                "expected at most " + std::to_string(device().max_texture_buffer_size) + " on " + device().renderer +
                    ", or reading through storage blocks");
  GLuint view = 0;
  GenTextures(1, &view);
  BindTexture(GL_TEXTURE_BUFFER, view);
  TexBuffer(GL_TEXTURE_BUFFER, internal_format, id_);
  views_.emplace(internal_format, view);
  return view;
}

}  // namespace fascia::gl
