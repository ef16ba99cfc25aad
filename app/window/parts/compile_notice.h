// Shows why the window is frozen while kernels are compiled. A driver that compiles a kernel at its first run takes
// seconds for all kernels of a method, or of a first grab; later starts find them in the driver's cache.
#pragma once
#include <chrono>

#include "app/overlay/overlay.h"

namespace fascia {

class CompileNotice {
 public:
  /// The notice can appear during the lifetime of the object, in which steps are made. It is shown over `picture`, the
  /// last one, whose first `left` columns the panels cover.
  CompileNotice(Graphics& graphics, Overlay& overlay, const Framebuffer& picture, int left);
  int kernels() const { return kernels_; }  // that ran for the first time in this lifetime

 private:
  void tell();

  Graphics& graphics_;
  Overlay& overlay_;
  const Framebuffer& picture_;
  int left_;
  int kernels_ = 0;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  gl::ProgramCache::FirstRuns first_runs_;
};

}  // namespace fascia
