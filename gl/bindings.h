// Buffers at the numbered binding points of storage blocks. Blocks of one name have one point in all kernels where that
// is possible, so that few bindings change from one pass to the next; while a KeptBindings exists, those that do not
// change are not made again.
#pragma once
#include <set>
#include <string>

#include "gl/loader.h"

namespace fascia::gl {

/// A point for a block of this name that is not in `taken`, to which it is added. Where there are more names than
/// points, a new name shares the point that was asked for least recently: most likely no kernel of the same step uses
/// it.
GLuint binding_point(const std::string& block, std::set<GLuint>& taken);

/// Binds a buffer to a point of GL_SHADER_STORAGE_BUFFER.
void bind_storage(GLuint point, GLuint buffer);
/// To be called before a buffer is deleted: its number may be given to another one.
void forget_bindings_of(GLuint buffer);
/// Calls of glBindBufferBase for storage blocks since the program started.
std::uint64_t binding_count();

/// From its creation until its end nobody else may bind storage buffers in this context.
class KeptBindings {
 public:
  KeptBindings();
  ~KeptBindings();
  KeptBindings(const KeptBindings&) = delete;
  KeptBindings& operator=(const KeptBindings&) = delete;
};

}  // namespace fascia::gl
