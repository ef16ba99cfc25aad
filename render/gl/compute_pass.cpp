#include "render/gl/compute_pass.h"

#include <algorithm>

#include "sim/error.h"

namespace fascia::gl {
namespace {

std::uint64_t dispatches = 0;

GLenum format_of(Texel texel) {
  switch (texel) {
    case Texel::vec4:
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

struct Property {
  GLint type, location;
};
Property uniform_property(GLuint program, GLuint index) {
  const GLenum wanted[] = {GL_TYPE, GL_LOCATION};
  Property result{};
  GLint values[2] = {};
  GetProgramResourceiv(program, GL_UNIFORM, index, 2, wanted, 2, nullptr, values);
  result.type = values[0];
  result.location = values[1];
  return result;
}

bool is_buffer_sampler(GLint type) {
  return type == GL_SAMPLER_BUFFER || type == GL_INT_SAMPLER_BUFFER || type == GL_UNSIGNED_INT_SAMPLER_BUFFER;
}

}  // namespace

std::uint64_t dispatch_count() {
  return dispatches;
}

ComputePass::ComputePass(const Program& program, Bindings buffers, std::uint32_t invocations)
    : program_(&program), buffers_(std::move(buffers)), invocations_(invocations) {
  resolve();
}

void ComputePass::resolve() const {
  const GLuint id = program_->id();
  const std::string where = "kernel " + program_->label();
  std::vector<bool> used(buffers_.size(), false);
  std::vector<Slot> slots;
  // `spell` turns the name of a binding into the name of the resource.
  const auto add = [&](const std::string& resource, auto spell, GLenum target, GLenum format, GLuint unit) {
    for (std::size_t i = 0; i < buffers_.size(); ++i) {
      if (spell(buffers_[i].first) != resource) continue;
      const Buffer& buffer = *buffers_[i].second;
      if (target == GL_TEXTURE_BUFFER)
        buffer.texel_view(format);  // made here, so that run() makes nothing
      else if (static_cast<std::int64_t>(buffer.bytes()) > device().max_storage_block_size)
        throw Error(where, "buffer " + buffer.label() + " has " + std::to_string(buffer.bytes()) + " bytes",
                    "expected at most " + std::to_string(device().max_storage_block_size) +
                        " in a block on " + device().renderer);
      used[i] = true;
      slots.push_back({&buffer, target, format, unit});
      return;
    }
    throw Error(where, resource + " has no buffer",
                "expected a binding for every buffer that the kernel uses");
  };
  for (const auto& [name, buffer] : buffers_)
    if (!buffer || !*buffer)
      throw Error(where, "the buffer for " + name + " was never made", "expected a buffer with memory");

  GLuint unit = 0;
  for (const std::string& block : resources(id, GL_SHADER_STORAGE_BLOCK)) {
    add(block, pascal_case, GL_SHADER_STORAGE_BUFFER, GL_NONE, unit);
    ShaderStorageBlockBinding(id, unit, unit);  // index i gets binding point i
    ++unit;
  }
  unit = 0;
  for (const std::string& block : resources(id, GL_UNIFORM_BLOCK)) {
    add(block, pascal_case, GL_UNIFORM_BUFFER, GL_NONE, unit);
    UniformBlockBinding(id, unit, unit);
    ++unit;
  }
  unit = 0;
  GLuint index = 0;
  for (const std::string& uniform : resources(id, GL_UNIFORM)) {
    const Property property = uniform_property(id, index++);
    if (!is_buffer_sampler(property.type)) continue;
    const auto declared = program_->declared().find(uniform);
    if (declared == program_->declared().end() || declared->second == Texel::none)
      throw Error(where, "the texel format of " + uniform + " is unknown",
                  "expected it to be declared with INPUT_*");
    add(
        uniform, [](const std::string& name) { return name; }, GL_TEXTURE_BUFFER, format_of(declared->second),
        unit);
    ProgramUniform1i(id, property.location, static_cast<GLint>(unit++));
  }

  for (std::size_t i = 0; i < buffers_.size(); ++i)
    if (!used[i] && !program_->declared().contains(buffers_[i].first))
      throw Error(where, "has no buffer named " + buffers_[i].first,
                  "expected a name that the kernel declares");
  for (const auto& [name, buffer] : buffers_)
    for (const auto& [other_name, other] : buffers_) {
      const auto a = program_->declared().find(name), b = program_->declared().find(other_name);
      if (buffer != other || a == program_->declared().end() || b == program_->declared().end()) continue;
      if (a->second != Texel::none && b->second == Texel::none)
        throw Error(where, name + " and " + other_name + " are one buffer, read and written",
                    "expected it once, as INOUT");
    }

  GLint group[3] = {};
  GetProgramiv(id, GL_COMPUTE_WORK_GROUP_SIZE, group);
  const auto size = static_cast<std::uint64_t>(group[0]);
  const std::uint64_t groups = (invocations_ + size - 1) / size;
  if (groups > static_cast<std::uint64_t>(device().max_compute_groups))
    throw Error(where, std::to_string(groups) + " work groups",
                "expected at most " + std::to_string(device().max_compute_groups));
  groups_ = static_cast<std::uint32_t>(groups);
  invocations_location_ = GetUniformLocation(id, "invocations");
  slots_ = std::move(slots);
  generation_ = program_->generation();
}

void ComputePass::run() const {
  if (generation_ != program_->generation()) resolve();
  if (groups_ == 0) return;
  program_->use();
  for (const Slot& slot : slots_) {
    if (slot.target == GL_TEXTURE_BUFFER) {
      ActiveTexture(GL_TEXTURE0 + slot.unit);
      BindTexture(GL_TEXTURE_BUFFER, slot.buffer->texel_view(slot.format));
    } else {
      BindBufferBase(slot.target, slot.unit, slot.buffer->id());
    }
  }
  if (invocations_location_ >= 0) Uniform1ui(invocations_location_, invocations_);
  DispatchCompute(groups_, 1, 1);
  // Everything that later passes, draws and copies may do with the results.
  MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT | GL_UNIFORM_BARRIER_BIT |
                GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_ELEMENT_ARRAY_BARRIER_BIT | GL_COMMAND_BARRIER_BIT |
                GL_BUFFER_UPDATE_BARRIER_BIT);
  ++dispatches;
}

}  // namespace fascia::gl
