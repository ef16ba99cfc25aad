// On software renderers a session starts with single kernels, which compile in a second, and switches to fused kernels,
// which are twice as fast, as soon as another process has compiled them: first in whole steps, later in those in which
// a part of the tissue rests. Where the driver's cache is known to have them it starts with them. Both give bitwise
// equal results. GPUs have no fused kernels, so nothing switches there.
#pragma once
#include <functional>
#include <memory>
#include <optional>

#include "app/kernels/kernel_record.h"
#include "app/kernels/kernel_warmup.h"
#include "app/session/session.h"
#include "sim/simulation/simulation.h"

namespace fascia {

class KernelSwitch {
 public:
  /// With `wanted` false sessions have fused kernels from the start. `folder` keeps the record of cached kernels;
  /// empty: none.
  KernelSwitch(Graphics& graphics, bool wanted, const std::filesystem::path& folder);
  /// Calls `make`, which makes a session of this scene, with the kernels chosen for it. If it throws, those of the open
  /// session stay.
  std::unique_ptr<Session> make(const Scene& scene, const std::function<std::unique_ptr<Session>()>& make) const;
  /// The same for a change of a session that gives it this scene; session_began() follows.
  void change(const Scene& scene, const std::function<void()>& change) const;
  void session_began(const Simulation& simulation);
  /// Between two steps. `renew` is called when solvers must record their passes again, with fused kernels.
  void follow(const std::function<void()>& renew);
  /// Whether steps have single kernels because another process still compiles the fused ones.
  bool compiling() const;

 private:
  bool compiles(const Scene& scene) const;  // its kernels already

  Graphics& graphics_;
  bool switches_;
  KernelRecord record_;
  std::optional<KernelWarmup> warmup_;
};

}  // namespace fascia
