#include "sim/gpu/state_guard.h"

#include <utility>

namespace fascia {
namespace {

constexpr std::uint32_t kNone = ~0u;

}  // namespace

StateGuard::~StateGuard() {
  if (fence_) gl::DeleteSync(fence_);
}

void StateGuard::copy(const SimBuffers& buffers, double time, Copy& to) {
  const std::size_t bytes = sizeof(shared::vec4) * buffers.vertex_count;
  if (!to.displacement) {
    to.displacement = gl::Buffer("guard_displacement", bytes);
    to.velocity = gl::Buffer("guard_velocity", bytes);
  }
  to.displacement.copy(buffers.displacement, bytes);
  to.velocity.copy(buffers.velocity, bytes);
  to.time = time;
}

void StateGuard::keep(SimBuffers& buffers, double time) {
  clear(buffers);
  copy(buffers, time, good_);
}

void StateGuard::request(const SimBuffers& buffers, double time) {
  if (fence_) return;
  copy(buffers, time, candidate_);
  if (!note_) note_ = gl::Buffer("guard_note", sizeof(std::uint32_t));
  note_.copy(buffers.astray, sizeof(std::uint32_t));
  fence_ = gl::FenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
}

std::optional<StateGuard::Verdict> StateGuard::take(bool wait) {
  if (!fence_) return std::nullopt;
  if (gl::ClientWaitSync(fence_, GL_SYNC_FLUSH_COMMANDS_BIT, wait ? GLuint64(10'000'000'000) : 0) == GL_TIMEOUT_EXPIRED)
    return std::nullopt;
  gl::DeleteSync(fence_);
  fence_ = nullptr;
  const std::uint32_t astray = note_.read<std::uint32_t>().front();
  if (astray != kNone) return Verdict{astray};
  std::swap(good_, candidate_);
  return Verdict{};
}

void StateGuard::clear(SimBuffers& buffers) {
  if (fence_) gl::DeleteSync(fence_);
  fence_ = nullptr;
  buffers.astray.upload(0, sizeof kNone, &kNone);
}

double StateGuard::restore(SimBuffers& buffers) {
  buffers.displacement.copy(good_.displacement, good_.displacement.bytes());
  buffers.velocity.copy(good_.velocity, good_.velocity.bytes());
  clear(buffers);
  return good_.time;
}

}  // namespace fascia
