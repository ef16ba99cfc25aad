// On software renderers a session starts with single kernels, which compile in a second, and switches to fused kernels,
// which are twice as fast, as soon as another process has compiled them. Both give bitwise equal results. GPUs have no
// fused kernels, so nothing switches there.
#pragma once
#include <functional>
#include <optional>

#include "app/session/graphics.h"
#include "app/session/kernel_warmup.h"
#include "sim/simulation/simulation.h"

namespace fascia {

class KernelSwitch {
 public:
  /// With `wanted` false sessions have fused kernels from the start.
  KernelSwitch(Graphics& graphics, bool wanted);
  void session_began(const Simulation& simulation);
  /// Between two steps. `renew` is called when solvers must record their passes again, with fused kernels.
  void follow(const std::function<void()>& renew);

 private:
  Graphics& graphics_;
  bool switches_;
  std::optional<KernelWarmup> warmup_;
};

}  // namespace fascia
