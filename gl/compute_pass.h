// One recorded compute dispatch: a program, its buffers by block name, and the number of invocations. Kernels declare
// inputs with INPUT_* and outputs with OUTPUT_* (shaders/common/io.glsl). Binding points are assigned here, by name, so
// no number is written twice. A name that the program does not have, or a block without a buffer, is an Error.
#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gl/buffer.h"
#include "gl/program.h"

namespace fascia::gl {

class ComputePass {
 public:
  using Bindings = std::vector<std::pair<std::string, const Buffer*>>;   // block or sampler name -> buffer
  using Constants = std::vector<std::pair<std::string, std::uint32_t>>;  // name of a uint uniform -> value
  /// `invocations` is the number of items; the kernel's guard skips the rest of the last group. The buffers must
  /// outlive the pass. `constants` are this pass's values of the kernel's uniforms: other passes of the same program
  /// may have different ones. Throws Error.
  ComputePass(const Program& program, Bindings buffers, std::uint32_t invocations, Constants constants = {});

  /// Binds, makes the barrier that its accesses need after those before it (barriers.h), and dispatches. Throws Error
  /// only if a reloaded program needs other buffers.
  void run() const;
  const Program& program() const { return *program_; }
  std::uint32_t groups() const {
    prepare();
    return groups_;
  }
  /// Bytes of the given buffers, each counted once: an estimate of the memory traffic of a run that reads or writes all
  /// of them.
  std::size_t bytes() const;
  /// States that a run reads no more than the first `bytes` of the buffer that is bound as `name`, for bytes().
  void reads_first(const std::string& name, std::size_t bytes);
  /// Takes the numbers of groups from the three values of `arguments` (uint), from index `first`, at each run.
  void set_indirect(const Buffer& arguments, std::uint32_t first);
  const Buffer* arguments() const { return arguments_; }  // of set_indirect; null without
  /// Before each run the bytes of `from` are copied to the start of `to`.
  void copy_first(const Buffer& from, Buffer& to);
  /// Takes a constant, also "invocations", from the variable `value` at each run.
  void follow(const std::string& constant, const std::uint32_t& value);

  /// The largest number of iterations of all loops together in an invocation: passes that state it can be fused
  /// (fused_pass.h).
  ComputePass& loops(std::uint32_t most);
  std::optional<std::uint32_t> loops() const { return loops_; }
  /// Compiles the kernel, if that was postponed (program.h), and looks up the bindings. Throws Error.
  void prepare() const;

  // The recorded data.
  using Followed = std::vector<std::pair<std::string, const std::uint32_t*>>;
  const Bindings& bindings() const { return buffers_; }
  const Constants& constants() const { return constants_; }  // "invocations" among them
  const Followed& followed() const { return followed_; }
  std::uint32_t first_argument() const { return first_argument_; }
  std::pair<const Buffer*, const Buffer*> copied() const { return {copied_, copy_}; }  // of copy_first: from, to

 private:
  void resolve() const;  // block names to binding points; repeated after a reload
  struct Slot {
    const Buffer* buffer;
    GLenum target;  // GL_SHADER_STORAGE_BUFFER, GL_UNIFORM_BUFFER or GL_TEXTURE_BUFFER
    GLenum format;  // of the buffer texture
    GLuint unit;
    bool stores;  // whether the kernel may store into it
  };
  GLbitfield missing_barriers() const;
  const Program* program_;
  Bindings buffers_;
  Constants constants_;
  std::uint32_t invocations_ = 0;
  const Buffer* arguments_ = nullptr;  // of an indirect dispatch
  std::uint32_t first_argument_ = 0;
  const Buffer* copied_ = nullptr;  // before the dispatch, to copy_
  Buffer* copy_ = nullptr;
  Followed followed_;
  std::optional<std::uint32_t> loops_;
  std::map<const Buffer*, std::size_t> parts_;  // of reads_first()
  mutable std::uint32_t groups_ = 0, group_size_ = 1;
  mutable std::vector<std::pair<GLint, std::uint32_t>> uniforms_;  // location, value
  mutable std::vector<std::pair<GLint, const std::uint32_t*>> followed_uniforms_;
  mutable std::vector<Slot> slots_;
  mutable unsigned generation_ = 0;
};

/// Dispatches since the program started.
std::uint64_t dispatch_count();

}  // namespace fascia::gl
