// A point in the stream of GPU commands, with a test whether the GPU has reached it. Needs a current context, also in
// the destructor.
#pragma once
#include "gl/loader.h"

namespace fascia::gl {

class Fence {
 public:
  Fence() = default;
  ~Fence() { clear(); }
  Fence(const Fence&) = delete;
  Fence& operator=(const Fence&) = delete;

  /// Sets the fence here; an earlier position is discarded.
  void set() {
    clear();
    sync_ = FenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
  }
  void clear() {
    if (sync_) DeleteSync(sync_);
    sync_ = nullptr;
  }
  bool is_set() const { return sync_ != nullptr; }

  /// True once, when the fence is set and the GPU has passed it, which clears it; with `wait`, waits for that. False if
  /// it is not set.
  bool take(bool wait) {
    if (!sync_) return false;
    constexpr GLuint64 kSlice = 1'000'000'000;  // [ns]; drivers may limit a wait
    while (ClientWaitSync(sync_, GL_SYNC_FLUSH_COMMANDS_BIT, wait ? kSlice : 0) == GL_TIMEOUT_EXPIRED)
      if (!wait) return false;
    clear();
    return true;
  }

 private:
  GLsync sync_ = nullptr;
};

}  // namespace fascia::gl
