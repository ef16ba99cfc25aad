#include "tests/support/gpu/barrier_watch.h"

#include <array>
#include <bit>
#include <map>
#include <regex>
#include <tuple>
#include <vector>

#include "tests/support/gpu/swapped.h"

namespace fascia::test {
namespace watched {  // named, because a class with external linkage has a member of these types

struct BufferState {
  std::string label;
  long stored = 0, accessed = 0;  // the last command whose shaders did so
  std::string by;                 // the program of the last store
};

struct ProgramState {
  struct Sampler {
    GLint location;
    GLuint unit;  // by the text
  };
  std::string label, text;
  std::vector<GLuint> shaders;
  bool known = false;                       // whether the next two are filled
  std::map<std::string, bool> blocks;       // active storage blocks, in the order of their names; whether stored into
  std::map<std::string, GLuint> index;      // of a block
  std::map<std::string, Sampler> samplers;  // active buffer textures
  std::map<GLint, GLuint> units;            // location -> unit, as set by the program
};

struct Watch {
  GLbitfield left_out = 0, bits = 0;
  std::set<std::string> findings;
  long commands = 0, made = 0, needless = 0;
  struct Barrier {
    long last = 0, before = 0;  // commands before the last barrier with the bit and before the one before it
    bool needed = true;         // the last one
  };
  std::array<Barrier, 32> barriers{};
  std::map<GLuint, BufferState> buffers;
  std::map<GLuint, ProgramState> programs;
  std::map<GLuint, std::string> shader_text;
  std::map<GLenum, GLuint> bound;                  // target -> buffer
  std::map<std::pair<GLenum, GLuint>, GLuint> at;  // target, point -> buffer
  std::map<GLuint, GLuint> texture_at;             // unit -> buffer texture
  std::map<GLuint, GLuint> viewed;                 // buffer texture -> buffer
  struct Array {
    std::map<GLuint, GLuint> attributes;  // location -> buffer
    std::set<GLuint> enabled;
    GLuint elements = 0;
  };
  std::map<GLuint, Array> arrays;
  GLuint program = 0, unit = 0, array = 0;

  void access(GLuint buffer, GLbitfield kind, bool stores, const std::string& what) {
    const auto found = buffers.find(buffer);
    if (found == buffers.end()) return;
    const BufferState& state = found->second;
    const long last = stores ? state.accessed : state.stored;
    Barrier& barrier = barriers[static_cast<std::size_t>(std::countr_zero(kind))];
    if (last > barrier.last)
      findings.insert(what + " (" + state.label + ") needs the bit " + std::to_string(kind) + " after " + state.by);
    else if (last > barrier.before)
      barrier.needed = true;
  }

  void barrier(GLbitfield made_bits) {
    ++made;
    bits |= made_bits;
    for (std::size_t bit = 0; bit < barriers.size(); ++bit) {
      Barrier& b = barriers[bit];
      if (!(made_bits >> bit & 1u) || (left_out >> bit & 1u)) continue;
      if (!b.needed) ++needless;
      b = {commands, b.last, false};
    }
  }

  /// Reads from the driver and from the text what a program accesses.
  ProgramState& known_program() {
    ProgramState& p = programs[program];
    if (p.known) return p;
    p.known = true;
    p.text = std::regex_replace(p.text, std::regex("//[^\n]*"), "");
    const auto names_in = [&](const char* pattern) {
      std::set<std::string> names;
      const std::regex declaration(pattern);
      for (std::sregex_iterator it(p.text.begin(), p.text.end(), declaration), end; it != end; ++it)
        names.insert((*it)[1]);
      return names;
    };
    const std::set<std::string> read = names_in("INPUT_\\w+\\((\\w+),"),
                                stored = names_in("(?:OUTPUT|INOUT|COHERENT)\\(\\w+, *(\\w+),");
    const auto each = [&](GLenum interface, const auto& take) {
      GLint count = 0;
      gl::GetProgramInterfaceiv(program, interface, GL_ACTIVE_RESOURCES, &count);
      for (GLuint i = 0; i < static_cast<GLuint>(count); ++i) {
        std::array<char, 200> name{};
        gl::GetProgramResourceName(program, interface, i, name.size(), nullptr, name.data());
        take(i, std::string(name.data()));
      }
    };
    each(GL_SHADER_STORAGE_BLOCK, [&](GLuint i, const std::string& name) {
      p.blocks[name] = !read.contains(name) || stored.contains(name);
      p.index[name] = i;
    });
    each(GL_UNIFORM, [&](GLuint i, const std::string& name) {
      const GLenum properties[] = {GL_TYPE, GL_LOCATION};
      GLint values[2] = {};
      gl::GetProgramResourceiv(program, GL_UNIFORM, i, 2, properties, 2, nullptr, values);
      if (values[0] != GL_SAMPLER_BUFFER && values[0] != GL_UNSIGNED_INT_SAMPLER_BUFFER) return;
      std::smatch unit_of;
      const std::regex declaration("binding *= *(\\d+)\\) *uniform \\w+ " + name + ";");
      const bool declared = std::regex_search(p.text, unit_of, declaration);
      p.samplers[name] = {values[1], declared ? static_cast<GLuint>(std::stoul(unit_of[1])) : 0};
    });
    return p;
  }

  /// What a dispatch or draw accesses; afterwards it counts as made.
  void command(bool draws) {
    const ProgramState& p = known_program();
    std::vector<std::tuple<GLuint, bool>> accessed;  // buffer, stores
    const auto use = [&](GLuint buffer, GLbitfield kind, bool stores, const std::string& name) {
      access(buffer, kind, stores, p.label + ": " + name);
      accessed.emplace_back(buffer, stores);
    };
    for (const auto& [name, stores] : p.blocks) {
      const GLenum property = GL_BUFFER_BINDING;
      GLint point = 0;
      gl::GetProgramResourceiv(program, GL_SHADER_STORAGE_BLOCK, p.index.at(name), 1, &property, 1, nullptr, &point);
      const GLuint buffer = at[{GL_SHADER_STORAGE_BUFFER, static_cast<GLuint>(point)}];
      use(buffer, GL_SHADER_STORAGE_BARRIER_BIT, false, name);
      if (stores) use(buffer, GL_SHADER_STORAGE_BARRIER_BIT, true, name);
    }
    for (const auto& [name, sampler] : p.samplers) {
      const auto set = p.units.find(sampler.location);
      use(viewed[texture_at[set == p.units.end() ? sampler.unit : set->second]], GL_TEXTURE_FETCH_BARRIER_BIT, false,
          name);
    }
    for (const auto& [place, buffer] : at)
      if (place.first == GL_UNIFORM_BUFFER) use(buffer, GL_UNIFORM_BARRIER_BIT, false, "uniform block");
    if (draws) {
      const Array& vertices = arrays[array];
      for (const GLuint location : vertices.enabled)
        use(vertices.attributes.at(location), GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT, false, "vertices");
      use(vertices.elements, GL_ELEMENT_ARRAY_BARRIER_BIT, false, "indices");
    }
    ++commands;
    for (const auto& [buffer, stores] : accessed) {
      const auto found = buffers.find(buffer);
      if (found == buffers.end()) continue;
      found->second.accessed = commands;
      if (!stores) continue;
      found->second.stored = commands;
      found->second.by = p.label;
    }
  }

  void transfer(GLenum target, const char* what) { access(bound[target], GL_BUFFER_UPDATE_BARRIER_BIT, false, what); }
};

Watch* watch = nullptr;

}  // namespace watched

using namespace watched;

// Each of OpenGL's functions is followed by the watch and then called.
struct BarrierWatch::Hooks {
  Watch seen;
#define HOOK(name, parameters, arguments, act)              \
  static inline decltype(gl::name) real_##name;             \
  static void hooked_##name parameters {                    \
    act;                                                    \
    real_##name arguments;                                  \
  }                                                         \
  decltype(gl::name) taken_##name = real_##name = gl::name; \
  Swapped<decltype(gl::name)> swapped_##name{gl::name, &hooked_##name};

  HOOK(BindBuffer, (GLenum target, GLuint id), (target, id), {
    watch->bound[target] = id;
    if (id != 0) watch->buffers[id];
    if (target == GL_ELEMENT_ARRAY_BUFFER) watch->arrays[watch->array].elements = id;
  })
  HOOK(BindBufferBase, (GLenum target, GLuint point, GLuint id), (target, point, id), (watch->at[{target, point}] = id))
  HOOK(DeleteBuffers, (GLsizei count, const GLuint* ids), (count, ids), {
    for (GLsizei i = 0; i < count; ++i) watch->buffers.erase(ids[i]);
  })
  HOOK(ObjectLabel, (GLenum kind, GLuint id, GLsizei length, const GLchar* label), (kind, id, length, label), {
    const std::string text(label, static_cast<std::size_t>(length));
    if (kind == GL_BUFFER) watch->buffers[id].label = text;
    if (kind == GL_PROGRAM) watch->programs[id].label = text.substr(0, text.find(" ["));
  })
  HOOK(ActiveTexture, (GLenum unit), (unit), (watch->unit = unit - GL_TEXTURE0))
  HOOK(BindTexture, (GLenum target, GLuint id), (target, id), {
    if (target == GL_TEXTURE_BUFFER) watch->texture_at[watch->unit] = id;
  })
  HOOK(TexBuffer, (GLenum target, GLenum format, GLuint id), (target, format, id),
       (watch->viewed[watch->texture_at[watch->unit]] = id))
  HOOK(ShaderSource, (GLuint id, GLsizei count, const GLchar* const* text, const GLint* lengths),
       (id, count, text, lengths), (watch->shader_text[id] = text[0]))
  HOOK(AttachShader, (GLuint program, GLuint shader), (program, shader),
       watch->programs[program].shaders.push_back(shader))
  HOOK(LinkProgram, (GLuint id), (id), {
    for (const GLuint shader : watch->programs[id].shaders) watch->programs[id].text += watch->shader_text[shader];
  })
  HOOK(DeleteProgram, (GLuint id), (id), watch->programs.erase(id))
  HOOK(ProgramUniform1i, (GLuint id, GLint location, GLint value), (id, location, value),
       (watch->programs[id].units[location] = static_cast<GLuint>(value)))
  HOOK(UseProgram, (GLuint id), (id), (watch->program = id))
  HOOK(BindVertexArray, (GLuint id), (id), (watch->array = id))
  HOOK(VertexAttribPointer,
       (GLuint location, GLint size, GLenum type, GLboolean normalized, GLsizei stride, const void* from),
       (location, size, type, normalized, stride, from),
       (watch->arrays[watch->array].attributes[location] = watch->bound[GL_ARRAY_BUFFER]))
  HOOK(VertexAttribIPointer, (GLuint location, GLint size, GLenum type, GLsizei stride, const void* from),
       (location, size, type, stride, from),
       (watch->arrays[watch->array].attributes[location] = watch->bound[GL_ARRAY_BUFFER]))
  HOOK(EnableVertexAttribArray, (GLuint location), (location), watch->arrays[watch->array].enabled.insert(location))
  HOOK(MemoryBarrier, (GLbitfield bits), (bits), watch->barrier(bits))
  HOOK(DispatchCompute, (GLuint x, GLuint y, GLuint z), (x, y, z), watch->command(false))
  HOOK(DispatchComputeIndirect, (GLintptr at), (at), {
    watch->access(watch->bound[GL_DISPATCH_INDIRECT_BUFFER], GL_COMMAND_BARRIER_BIT, false, "indirect dispatch");
    watch->command(false);
  })
  HOOK(DrawArrays, (GLenum mode, GLint first, GLsizei count), (mode, first, count), watch->command(true))
  HOOK(DrawArraysInstanced, (GLenum mode, GLint first, GLsizei count, GLsizei times), (mode, first, count, times),
       watch->command(true))
  HOOK(DrawElements, (GLenum mode, GLsizei count, GLenum type, const void* from), (mode, count, type, from),
       watch->command(true))
  HOOK(BufferSubData, (GLenum target, GLintptr at, GLsizeiptr bytes, const void* data), (target, at, bytes, data),
       watch->transfer(target, "upload"))
  HOOK(GetBufferSubData, (GLenum target, GLintptr at, GLsizeiptr bytes, void* data), (target, at, bytes, data),
       watch->transfer(target, "download"))
  HOOK(CopyBufferSubData, (GLenum from, GLenum to, GLintptr from_at, GLintptr to_at, GLsizeiptr bytes),
       (from, to, from_at, to_at, bytes), {
         watch->transfer(from, "copy from");
         watch->transfer(to, "copy to");
       })
#undef HOOK
};

BarrierWatch::BarrierWatch(GLbitfield left_out) : hooks_(std::make_unique<Hooks>()) {
  hooks_->seen.left_out = left_out;
  watch = &hooks_->seen;
}

BarrierWatch::~BarrierWatch() = default;

const std::set<std::string>& BarrierWatch::findings() const { return hooks_->seen.findings; }
GLbitfield BarrierWatch::bits() const { return hooks_->seen.bits; }
long BarrierWatch::barriers() const { return hooks_->seen.made; }
long BarrierWatch::commands() const { return hooks_->seen.commands; }
long BarrierWatch::needless_bits() const { return hooks_->seen.needless; }

}  // namespace fascia::test
