#include "sim/gpu/readback/state_guard.h"

#include <bit>
#include <cmath>
#include <utility>

namespace fascia {
namespace {

constexpr std::uint32_t kNone = ~0u;
constexpr std::size_t kWord = sizeof(std::uint32_t);
constexpr std::uint32_t kMeasured = 0x5eed0002;  // that motion.comp ran

}  // namespace

StateGuard::StateGuard(gl::ProgramCache& programs, SimBuffers& buffers) : programs_(programs) { keep(buffers, {}); }

void StateGuard::copy(const SimBuffers& buffers, const Moment& moment, Copy& to) {
  const std::size_t bytes = sizeof(shared::vec4) * buffers.vertex_count;
  if (!to.displacement) {
    to.displacement = gl::Buffer("guard_displacement", bytes);
    to.velocity = gl::Buffer("guard_velocity", bytes);
  }
  to.displacement.copy(buffers.displacement, bytes);
  to.velocity.copy(buffers.velocity, bytes);
  to.moment = moment;
  if (buffers.contact_memory) {
    if (!to.contact_memory) to.contact_memory = gl::Buffer("guard_contact_memory", buffers.contact_memory.bytes());
    to.contact_memory.copy(buffers.contact_memory, buffers.contact_memory.bytes());
  }
  if (moment.earlier_step == 0) return;
  if (!to.earlier_displacement) {
    to.earlier_displacement = gl::Buffer("guard_earlier_displacement", bytes);
    to.earlier_velocity = gl::Buffer("guard_earlier_velocity", bytes);
  }
  to.earlier_displacement.copy(buffers.earlier_displacement, bytes);
  to.earlier_velocity.copy(buffers.earlier_velocity, bytes);
}

void StateGuard::keep(SimBuffers& buffers, const Moment& moment) {
  clear(buffers);
  copy(buffers, moment, good_);
}

void StateGuard::request(const SimBuffers& buffers, const Moment& moment) {
  if (fence_.is_set()) return;
  if (!measure_) {
    motion_ = gl::Buffer("motion", 4 * kWord);
    note_ = gl::Buffer::staging("guard_note", 5 * kWord);
    measure_.emplace(programs_.compute("sim/readback/motion.comp", {{"MEASURED", std::to_string(kMeasured) + "u"}}),
                     gl::ComputePass::Bindings{{"displacement", &buffers.displacement},
                                               {"velocity", &buffers.velocity},
                                               {"earlier_displacement", &good_.displacement},
                                               {"motion", &motion_}},
                     Reduction(programs_, buffers.vertex_count).lanes,
                     gl::ComputePass::Constants{{"vertex_count", buffers.vertex_count}});
  }
  constexpr std::uint32_t kZero[4] = {};
  motion_.upload(0, sizeof kZero, kZero);
  measure_->run();
  copy(buffers, moment, candidate_);
  note_.copy(buffers.diverged, kWord);
  note_.copy(motion_, motion_.bytes(), kWord);
  fence_.set();
}

std::optional<StateGuard::Verdict> StateGuard::take(bool wait) {
  if (!fence_.take(wait)) return std::nullopt;
  const auto note = note_.read<std::uint32_t>();
  const bool measured = note[4] == kMeasured;
  if (note[0] != kNone) return Verdict{note[0], {}, measured};
  const auto length = [&](std::size_t k) { return std::sqrt(static_cast<double>(std::bit_cast<float>(note[k]))); };
  const Movement movement{candidate_.moment.time - good_.moment.time, length(1), length(2), length(3)};
  std::swap(good_, candidate_);
  return Verdict{std::nullopt, movement, measured};
}

void StateGuard::clear(SimBuffers& buffers) {
  fence_.clear();
  buffers.diverged.upload(0, sizeof kNone, &kNone);
}

State StateGuard::download(const SimBuffers& buffers) const {
  State state{buffers.download_vectors(good_.displacement), buffers.download_vectors(good_.velocity),
              good_.moment.time};
  if (good_.contact_memory) state.contact = buffers.contact_forces(good_.contact_memory);
  if (good_.moment.earlier_step > 0)
    state.earlier = {buffers.download_vectors(good_.earlier_displacement),
                     buffers.download_vectors(good_.earlier_velocity), good_.moment.earlier_step};
  return state;
}

StateGuard::Moment StateGuard::restore(SimBuffers& buffers) {
  buffers.displacement.copy(good_.displacement, good_.displacement.bytes());
  buffers.velocity.copy(good_.velocity, good_.velocity.bytes());
  if (good_.contact_memory) buffers.contact_memory.copy(good_.contact_memory, good_.contact_memory.bytes());
  clear(buffers);
  if (!buffers.earlier_displacement || good_.moment.earlier_step == 0) return {good_.moment.time};
  buffers.earlier_displacement.copy(good_.earlier_displacement, good_.earlier_displacement.bytes());
  buffers.earlier_velocity.copy(good_.earlier_velocity, good_.earlier_velocity.bytes());
  return good_.moment;
}

}  // namespace fascia
