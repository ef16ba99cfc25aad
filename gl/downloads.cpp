#include "gl/downloads.h"

#include <cstring>

#include "gl/loader.h"

namespace fascia::gl {

void Downloads::add(const Buffer& from, std::size_t bytes, void* to) { parts_.push_back({&from, bytes, to}); }

void Downloads::run() {
  if (device().software) {  // nothing to wait for, and copies of copies would cost
    for (const Part& part : parts_) part.from->download(0, part.bytes, part.to);
    parts_.clear();
    return;
  }
  std::size_t size = 0;
  for (const Part& part : parts_) size += part.bytes;
  if (!staging_ || staging_.bytes() < size) staging_ = Buffer::staging("downloads_staging", size);
  std::size_t place = 0;
  for (const Part& part : parts_) {
    staging_.copy(*part.from, part.bytes, place);
    place += part.bytes;
  }
  bytes_.resize(size);
  staging_.download(0, size, bytes_.data());
  const std::byte* next = bytes_.data();
  for (const Part& part : parts_) {
    std::memcpy(part.to, next, part.bytes);
    next += part.bytes;
  }
  parts_.clear();
}

}  // namespace fascia::gl
