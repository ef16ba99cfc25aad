#include "gl/compute_pass.h"

#include <algorithm>
#include <set>

#include "base/error.h"
#include "gl/bindings.h"

namespace fascia::gl {
namespace {

std::uint64_t dispatches = 0;

GLenum format_of(Texel texel) {
  switch (texel) {
    case Texel::vec4:
    case Texel::vec4_in_place:
      return GL_RGBA32F;
    case Texel::uvec4:
      return GL_RGBA32UI;
    case Texel::float1:
      return GL_R32F;
    case Texel::uint1:
      return GL_R32UI;
    case Texel::none:
      break;
  }
  return GL_NONE;
}

/// The barrier between stores and the reads of a slot.
GLbitfield barrier_of(GLenum target) {
  return target == GL_SHADER_STORAGE_BUFFER ? GL_SHADER_STORAGE_BARRIER_BIT
         : target == GL_TEXTURE_BUFFER      ? GL_TEXTURE_FETCH_BARRIER_BIT
                                            : GL_UNIFORM_BARRIER_BIT;
}

/// Names of a program's active resources of one kind, in the order of their indices.
std::vector<std::string> resources(GLuint program, GLenum interface) {
  GLint count = 0, longest = 0;
  GetProgramInterfaceiv(program, interface, GL_ACTIVE_RESOURCES, &count);
  GetProgramInterfaceiv(program, interface, GL_MAX_NAME_LENGTH, &longest);
  std::vector<std::string> names;
  std::string name(static_cast<std::size_t>(longest) + 1, '\0');
  for (GLuint i = 0; i < static_cast<GLuint>(count); ++i) {
    GLsizei length = 0;
    GetProgramResourceName(program, interface, i, longest + 1, &length, name.data());
    names.push_back(name.substr(0, static_cast<std::size_t>(length)));
  }
  return names;
}

/// A buffer that a program uses, under its name in OpenGL.
struct Wanted {
  std::string resource;
  GLenum target, format;
  GLuint unit;
};

/// Binding points depend on the program alone, so that all its passes agree.
std::vector<Wanted> assign_units(const Program& program, const std::string& where) {
  const GLuint id = program.id();
  std::vector<Wanted> wanted;
  std::set<GLuint> taken;
  GLuint place = 0;  // a block's index is its place in the list
  for (const std::string& block : resources(id, GL_SHADER_STORAGE_BLOCK)) {
    const GLuint point = binding_point(block, taken);
    ShaderStorageBlockBinding(id, place++, point);
    wanted.push_back({block, GL_SHADER_STORAGE_BUFFER, GL_NONE, point});
  }
  GLuint unit = 0;
  for (const std::string& block : resources(id, GL_UNIFORM_BLOCK)) {
    UniformBlockBinding(id, unit, unit);
    wanted.push_back({block, GL_UNIFORM_BUFFER, GL_NONE, unit++});
  }
  unit = 0;
  GLuint index = 0;
  for (const std::string& uniform : resources(id, GL_UNIFORM)) {
    const GLenum properties[] = {GL_TYPE, GL_LOCATION};
    GLint values[2] = {};
    GetProgramResourceiv(id, GL_UNIFORM, index++, 2, properties, 2, nullptr, values);
    const auto [type, location] = values;
    if (type != GL_SAMPLER_BUFFER && type != GL_INT_SAMPLER_BUFFER && type != GL_UNSIGNED_INT_SAMPLER_BUFFER) continue;
    const auto declared = program.declared().find(uniform);
    if (declared == program.declared().end() || declared->second == Texel::none)
      throw Error(where, "the texel format of " + uniform + " is unknown", "expected it to be declared with INPUT_*");
    ProgramUniform1i(id, location, static_cast<GLint>(unit));
    wanted.push_back({uniform, GL_TEXTURE_BUFFER, format_of(declared->second), unit++});
  }
  return wanted;
}

/// Checks the buffers, including those that the driver removed from the kernel.
void check_bindings(const Program& program, const ComputePass::Bindings& buffers, const std::string& where) {
  const auto& declared = program.declared();
  const auto is_input = [&](const std::string& name) {
    return declared.contains(name) && declared.at(name) != Texel::none && declared.at(name) != Texel::vec4_in_place;
  };
  const auto is_output = [&](const std::string& name) {
    return declared.contains(name) && declared.at(name) == Texel::none;
  };
  for (std::size_t i = 0; i < buffers.size(); ++i) {
    const auto& [name, buffer] = buffers[i];
    if (!buffer || !*buffer)
      throw Error(where, "the buffer for " + name + " was never made", "expected a buffer with memory");
    for (std::size_t k = 0; k < buffers.size(); ++k) {
      const auto& [other_name, other] = buffers[k];
      if (k < i && name == other_name) throw Error(where, name + " is bound twice", "expected one buffer for one name");
      if (buffer == other && is_input(name) && is_output(other_name) && !program.fused())
        throw Error(where, name + " and " + other_name + " are one buffer, read and written",
                    "expected it once, as INOUT, or read as INPUT_VEC4_IN_PLACE");
    }
  }
}

}  // namespace

std::uint64_t dispatch_count() { return dispatches; }

ComputePass::ComputePass(const Program& program, Bindings buffers, std::uint32_t invocations, Constants constants)
    : program_(&program), buffers_(std::move(buffers)), constants_(std::move(constants)), invocations_(invocations) {
  constants_.emplace_back("invocations", invocations);
  if (program.id())
    resolve();
  else
    check_bindings(program, buffers_, "kernel " + program.label());
}

void ComputePass::prepare() const {
  program_->require();
  if (generation_ != program_->generation()) resolve();
}

ComputePass& ComputePass::loops(std::uint32_t most) {
  loops_ = most;
  return *this;
}

void ComputePass::resolve() const {
  const std::string where = "kernel " + program_->label();
  check_bindings(*program_, buffers_, where);
  std::vector<bool> used(buffers_.size(), false);
  std::vector<Slot> slots;
  for (const Wanted& wanted : assign_units(*program_, where)) {
    const bool texels = wanted.target == GL_TEXTURE_BUFFER;
    const auto bound = std::find_if(buffers_.begin(), buffers_.end(), [&](const auto& binding) {
      return (texels ? binding.first : pascal_case(binding.first)) == wanted.resource;
    });
    if (bound == buffers_.end())
      throw Error(where, wanted.resource + " has no buffer",
                  "expected a binding for every buffer that the kernel uses");
    const Buffer& buffer = *bound->second;
    if (texels)
      buffer.texel_view(wanted.format);  // created here, so that run() creates nothing
    else if (static_cast<std::int64_t>(buffer.bytes()) > device().max_storage_block_size)
      throw Error(where, "buffer " + buffer.label() + " has " + std::to_string(buffer.bytes()) + " bytes",
                  "expected at most " + std::to_string(device().max_storage_block_size) + " in a block on " +
                      device().renderer);
    used[static_cast<std::size_t>(bound - buffers_.begin())] = true;
    const auto declared = program_->declared().find(bound->first);
    const bool stores = wanted.target == GL_SHADER_STORAGE_BUFFER &&
                        (declared == program_->declared().end() || declared->second == Texel::none);
    slots.push_back({&buffer, wanted.target, wanted.format, wanted.unit, stores});
  }
  // A declared buffer may be unused: the driver drops inputs without effect.
  for (std::size_t i = 0; i < buffers_.size(); ++i)
    if (!used[i] && !program_->declared().contains(buffers_[i].first))
      throw Error(where, "has no buffer named " + buffers_[i].first, "expected a name that the kernel declares");

  GLint group[3] = {};
  GetProgramiv(program_->id(), GL_COMPUTE_WORK_GROUP_SIZE, group);
  const auto size = static_cast<std::uint64_t>(group[0]);
  const std::uint64_t groups = (invocations_ + size - 1) / size;
  if (groups > static_cast<std::uint64_t>(device().max_compute_groups))
    throw Error(where, std::to_string(groups) + " work groups",
                "expected at most " + std::to_string(device().max_compute_groups));
  groups_ = static_cast<std::uint32_t>(groups);
  group_size_ = static_cast<std::uint32_t>(size);
  uniforms_.clear();  // a uniform that the driver optimized away has no location
  for (const auto& [name, value] : constants_)
    if (const GLint location = GetUniformLocation(program_->id(), name.c_str()); location >= 0)
      uniforms_.emplace_back(location, value);
  followed_uniforms_.clear();
  for (const auto& [name, value] : followed_)
    if (const GLint location = GetUniformLocation(program_->id(), name.c_str()); location >= 0)
      followed_uniforms_.emplace_back(location, value);
  slots_ = std::move(slots);
  generation_ = program_->generation();
}

void ComputePass::set_indirect(const Buffer& arguments, std::uint32_t first) {
  arguments_ = &arguments;
  first_argument_ = first;
}

void ComputePass::copy_first(const Buffer& from, Buffer& to) {
  copied_ = &from;
  copy_ = &to;
}

void ComputePass::follow(const std::string& constant, const std::uint32_t& value) {
  followed_.emplace_back(constant, &value);
  if (program_->id()) resolve();
}

std::size_t ComputePass::bytes() const {
  std::set<const Buffer*> counted;
  std::size_t bytes = 0;
  for (const auto& [name, buffer] : buffers_) {
    if (!counted.insert(buffer).second) continue;
    const auto part = parts_.find(buffer);
    bytes += part == parts_.end() ? buffer->bytes() : std::min(part->second, buffer->bytes());
  }
  return bytes;
}

void ComputePass::reads_first(const std::string& name, std::size_t bytes) {
  for (const auto& [bound, buffer] : buffers_)
    if (bound == name) parts_[buffer] = bytes;
}

GLbitfield ComputePass::missing_barriers() const {
  GLbitfield missing = arguments_ ? arguments_->shader_access().missing(GL_COMMAND_BARRIER_BIT) : 0;
  for (const Slot& slot : slots_) {
    const ShaderAccess& access = slot.buffer->shader_access();
    missing |= slot.stores ? access.missing_before_store() : access.missing(barrier_of(slot.target));
  }
  return missing;
}

void ComputePass::run() const {
  program_->begin_run();
  prepare();
  std::uint32_t groups = groups_;
  for (const auto& [name, value] : followed_)
    if (name == "invocations") groups = (*value + group_size_ - 1) / group_size_;
  if (copy_) copy_->copy(*copied_, copied_->bytes());
  if (groups == 0) return;
  program_->use();
  for (const Slot& slot : slots_) {
    if (slot.target == GL_TEXTURE_BUFFER) {
      ActiveTexture(GL_TEXTURE0 + slot.unit);
      BindTexture(GL_TEXTURE_BUFFER, slot.buffer->texel_view(slot.format));
    } else if (slot.target == GL_SHADER_STORAGE_BUFFER) {
      bind_storage(slot.unit, slot.buffer->id());
    } else {
      BindBufferBase(slot.target, slot.unit, slot.buffer->id());
    }
  }
  for (const auto& [location, value] : uniforms_) Uniform1ui(location, value);
  for (const auto& [location, value] : followed_uniforms_) Uniform1ui(location, *value);
  make_barrier(missing_barriers());
  if (arguments_) {
    BindBuffer(GL_DISPATCH_INDIRECT_BUFFER, arguments_->id());
    DispatchComputeIndirect(static_cast<GLintptr>(sizeof(std::uint32_t) * first_argument_));
  } else {
    DispatchCompute(groups, 1, 1);
  }
  const std::uint64_t command = next_command();
  for (const Slot& slot : slots_)
    if (slot.stores)
      slot.buffer->shader_access().stored_by(command);
    else
      slot.buffer->shader_access().read_by(command);
  program_->end_run();
  ++dispatches;
}

}  // namespace fascia::gl
