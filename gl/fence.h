// A point in the stream of GPU commands, and whether the GPU has come there. Needs a current context, the destructor
// too.
#pragma once
#include "gl/loader.h"

namespace fascia::gl {

class Fence {
 public:
  Fence() = default;
  ~Fence() { clear(); }
  Fence(const Fence&) = delete;
  Fence& operator=(const Fence&) = delete;

  /// Here, and no longer where it was.
  void set() {
    clear();
    sync_ = FenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
  }
  void clear() {
    if (sync_) DeleteSync(sync_);
    sync_ = nullptr;
  }
  bool is_set() const { return sync_ != nullptr; }

  /// Once, when a fence that is set has been passed, which clears it; with `wait`, waits for that. False when none is
  /// set, too.
  bool take(bool wait) {
    if (!sync_) return false;
    constexpr GLuint64 kSlice = 1'000'000'000;  // [ns]; drivers may bound a wait
    while (ClientWaitSync(sync_, GL_SYNC_FLUSH_COMMANDS_BIT, wait ? kSlice : 0) == GL_TIMEOUT_EXPIRED)
      if (!wait) return false;
    clear();
    return true;
  }

 private:
  GLsync sync_ = nullptr;
};

}  // namespace fascia::gl
