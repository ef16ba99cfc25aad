#include "app/window/parts/kernel_switch.h"

#include "gl/fused_pass.h"

namespace fascia {

KernelSwitch::KernelSwitch(Graphics& graphics, bool wanted, const std::filesystem::path& folder)
    : graphics_(graphics),
      switches_(wanted && gl::fuses(*graphics.programs)),
      record_(folder.empty() ? folder : folder / "kernels", describe(graphics)) {}

bool KernelSwitch::compiles(const Scene& scene) const { return warmup_ && record_.same(warmup_->scene(), scene); }

std::unique_ptr<Session> KernelSwitch::make(const Scene& scene,
                                            const std::function<std::unique_ptr<Session>()>& make) const {
  std::unique_ptr<Session> session;
  change(scene, [&] { session = make(); });
  return session;
}

void KernelSwitch::change(const Scene& scene, const std::function<void()>& change) const {
  gl::ProgramCache& programs = *graphics_.programs;
  const bool fusing = programs.fusing(), rare = programs.fusing_rare();
  if (switches_ && !compiles(scene)) programs.set_fusing(record_.has(scene));
  try {
    change();
  } catch (...) {
    programs.set_fusing(fusing, rare);
    throw;
  }
}

void KernelSwitch::session_began(const Simulation& simulation) {
  if (compiles(simulation.scene)) return;
  warmup_.reset();
  if (!switches_ || graphics_.programs->fusing()) return;
  if (simulation.uses_reference() || simulation.scene.solver.tolerance > 0)  // no step of it is fused at first
    graphics_.programs->set_fusing(true);
  else
    warmup_.emplace(std::filesystem::read_symlink("/proc/self/exe"), simulation.scene, graphics_.data_dir);
}

bool KernelSwitch::compiling() const { return warmup_ && !graphics_.programs->fusing(); }

// Where the other process fails or the driver keeps no cache, the fused kernels are compiled here: the window waits
// once and shows a notice, but it does not stay slow.
void KernelSwitch::follow(const std::function<void()>& renew) {
  if (!warmup_) return;
  const KernelWarmup::State state = warmup_->look();
  const bool of_whole_steps = state == KernelWarmup::State::whole_steps;
  if (state == KernelWarmup::State::running || (of_whole_steps && graphics_.programs->fusing())) return;
  if (state == KernelWarmup::State::cached) record_.add(warmup_->scene());
  if (!of_whole_steps) warmup_.reset();
  graphics_.programs->set_fusing(true, !of_whole_steps);
  renew();
}

}  // namespace fascia
