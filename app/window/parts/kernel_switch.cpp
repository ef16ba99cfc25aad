#include "app/window/parts/kernel_switch.h"

#include "gl/fused_pass.h"

namespace fascia {

KernelSwitch::KernelSwitch(Graphics& graphics, bool wanted)
    : graphics_(graphics), switches_(wanted && gl::fuses(*graphics.programs)) {}

void KernelSwitch::session_began(const Simulation& simulation) {
  warmup_.reset();
  const bool steps_on_gpu = !simulation.uses_reference() && simulation.scene.solver.tolerance == 0;
  if (switches_ && !graphics_.programs->fusing() && steps_on_gpu)
    warmup_.emplace(std::filesystem::read_symlink("/proc/self/exe"), simulation.scene, simulation.model,
                    graphics_.data_dir);
}

void KernelSwitch::follow(const std::function<void()>& renew) {
  if (!warmup_ || warmup_->look() == KernelWarmup::State::running) return;
  const bool cached = warmup_->look() == KernelWarmup::State::cached;
  warmup_.reset();
  if (!cached) return;  // compiling in this process would freeze the window
  graphics_.programs->set_fusing(true);
  renew();
}

}  // namespace fascia
