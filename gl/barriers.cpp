#include "gl/barriers.h"

#include <array>
#include <bit>

namespace fascia::gl {
namespace {

constexpr std::size_t kBits = 32;
std::uint64_t commands = 0;                   // so far
std::array<std::uint64_t, kBits> barriers{};  // [bit] commands before the last barrier with it

}  // namespace

GLbitfield ShaderAccess::missing(GLbitfield kind) const {
  return stored_ > barriers[static_cast<std::size_t>(std::countr_zero(kind))] ? kind : 0;
}

GLbitfield ShaderAccess::missing_before_store() const {
  constexpr GLbitfield kKind = GL_SHADER_STORAGE_BARRIER_BIT;
  return accessed_ > barriers[std::countr_zero(kKind)] ? kKind : 0;
}

void make_barrier(GLbitfield bits) {
  if (bits == 0) return;
  MemoryBarrier(bits);
  for (std::size_t bit = 0; bit < kBits; ++bit)
    if (bits >> bit & 1u) barriers[bit] = commands;
}

std::uint64_t next_command() { return ++commands; }

void forget_barriers() { barriers = {}; }

}  // namespace fascia::gl
