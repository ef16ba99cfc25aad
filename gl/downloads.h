// Downloads of several buffers with one wait for the GPU.
#pragma once
#include "gl/buffer.h"

namespace fascia::gl {

class Downloads {
 public:
  /// `to`: room for `bytes` until run() has returned.
  void add(const Buffer& from, std::size_t bytes, void* to);
  void run();

 private:
  struct Part {
    const Buffer* from;
    std::size_t bytes;
    void* to;
  };
  std::vector<Part> parts_;
  Buffer staging_;                // kept for the next ones
  std::vector<std::byte> bytes_;  // its content
};

}  // namespace fascia::gl
