// Says why the window stands still while kernels are compiled. A driver that translates a kernel when it first runs
// takes seconds for all of a method's, or of a first grab's; later starts find them in the driver's cache.
#pragma once
#include <chrono>

#include "app/overlay/overlay.h"

namespace fascia {

class CompileNotice {
 public:
  /// As long as it lives, which is while steps are made. Shown over `picture`, the last one, whose first `left` columns
  /// the panels cover.
  CompileNotice(Graphics& graphics, Overlay& overlay, const Framebuffer& picture, int left);
  int kernels() const { return kernels_; }  // that ran for the first time meanwhile

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
