// Barriers by need. What a shader stores reaches a later command, and comes after the accesses of earlier ones, only
// across a glMemoryBarrier with the bit of the later command's kind of access (OpenGL 4.3, 7.12.2). Buffers remember
// their last accesses by shaders; each command makes a barrier with the bits that its own accesses still need, or none.
// Copies, uploads and downloads need one after stores only: OpenGL orders them among all other commands.
#pragma once
#include <algorithm>

#include "gl/loader.h"

namespace fascia::gl {

/// When shaders last accessed a buffer, in numbers of commands.
class ShaderAccess {
 public:
  /// `kind`, a bit of glMemoryBarrier, if a barrier with it is missing before a command that accesses the buffer in
  /// this way; else 0.
  GLbitfield missing(GLbitfield kind) const;
  /// The same before a command whose shaders store into the buffer, with or without reading it.
  GLbitfield missing_before_store() const;
  void read_by(std::uint64_t command) { accessed_ = std::max(accessed_, command); }
  void stored_by(std::uint64_t command) {
    stored_ = command;
    read_by(command);
  }
  /// From now on, commands of others may read it at any time.
  void read_by_others() { accessed_ = ~std::uint64_t{0}; }

 private:
  std::uint64_t stored_ = 0, accessed_ = 0;  // 0: never
};

/// glMemoryBarrier, unless there are no bits.
void make_barrier(GLbitfield bits);
/// The number of a dispatch or draw that is made now.
std::uint64_t next_command();
/// As if no barrier had been made: for another context.
void forget_barriers();

}  // namespace fascia::gl
