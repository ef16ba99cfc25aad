// Preloaded into fascia: makes OpenGL fail as FASCIA_FAULT says. "drop:N": dispatches from the Nth on do nothing;
// "allocation:N": the Nth buffer has no room; "link:N": the Nth program does not link; "lost:N": the context is lost at
// the Nth dispatch; "garbage:N": reads from the Nth on return 0xff; "trusted:N": reads from the Nth on that may be the
// probe's find a device that computes (sim/gpu/passes/compute_probe.h). Numbers begin at 1. Prints the number of such
// calls at the end, "0 of the fault", to FASCIA_FAULT_COUNT.
#ifndef GL_GLEXT_PROTOTYPES
#define GL_GLEXT_PROTOTYPES
#endif
#include <GL/glcorearb.h>
#include <dlfcn.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "sim/gpu/passes/probe_words.h"

namespace {

using Function = void (*)();
using GetProc = Function (*)(const char*);

struct Fault {
  std::string kind;
  long at = 0, calls = 0;
  Fault() {
    const char* const text = std::getenv("FASCIA_FAULT");
    if (!text || !std::strchr(text, ':')) return;
    kind.assign(text, std::strchr(text, ':'));
    at = std::atol(std::strchr(text, ':') + 1);
  }
  ~Fault() {
    const char* const path = std::getenv("FASCIA_FAULT_COUNT");
    if (std::FILE* const file = path ? std::fopen(path, "w") : nullptr) {
      std::fprintf(file, "%ld", calls);
      std::fclose(file);
    }
  }
  bool is(const char* name) const { return kind == name; }
  /// Counts a call; whether it is the one, or from that one on.
  bool now() { return ++calls == at; }
  bool from_now() { return ++calls >= at; }
};

Fault& fault() {
  static Fault the_fault;
  return the_fault;
}

GetProc get_proc;
bool no_room, lost;
GLuint unlinked;

template <class F>
F real(F, const char* name) {
  return reinterpret_cast<F>(get_proc(name));
}
#define REAL(function) real(&::function, #function)

void dispatch(GLuint x, GLuint y, GLuint z) {
  if (fault().is("lost") && fault().from_now()) lost = true;
  if (lost || (fault().is("drop") && fault().from_now())) return;
  REAL(glDispatchCompute)(x, y, z);
}

void dispatch_indirect(GLintptr at) {
  if (fault().is("lost") && fault().from_now()) lost = true;
  if (lost || (fault().is("drop") && fault().from_now())) return;
  REAL(glDispatchComputeIndirect)(at);
}

void buffer_data(GLenum target, GLsizeiptr size, const void* data, GLenum usage) {
  if (fault().is("allocation") && fault().now())
    no_room = true;
  else
    REAL(glBufferData)(target, size, data, usage);
}

void buffer_storage(GLenum target, GLsizeiptr size, const void* data, GLbitfield flags) {
  if (fault().is("allocation") && fault().now())
    no_room = true;
  else
    REAL(glBufferStorage)(target, size, data, flags);
}

GLenum get_error() {
  if (!no_room) return lost ? static_cast<GLenum>(GL_CONTEXT_LOST) : REAL(glGetError)();
  no_room = false;
  return GL_OUT_OF_MEMORY;
}

void link_program(GLuint program) {
  if (fault().is("link") && fault().now()) unlinked = program;
  REAL(glLinkProgram)(program);
}

void get_program(GLuint program, GLenum name, GLint* value) {
  REAL(glGetProgramiv)(program, name, value);
  if (unlinked != 0 && program == unlinked && name == GL_LINK_STATUS) *value = GL_FALSE;
}

void get_buffer(GLenum target, GLintptr at, GLsizeiptr bytes, void* data) {
  if (lost) return;  // as the specification permits, nothing is written
  REAL(glGetBufferSubData)(target, at, bytes, data);
  if (fault().is("garbage") && fault().from_now()) std::memset(data, 0xff, static_cast<std::size_t>(bytes));
  if (bytes == fascia::kProbeRepeats * sizeof fascia::kProbeWords && fault().is("trusted") && fault().from_now())
    std::fill_n(static_cast<std::array<std::uint32_t, 4>*>(data), fascia::kProbeRepeats, fascia::kProbeWords);
}

GLenum reset_status() {
  return lost ? static_cast<GLenum>(GL_UNKNOWN_CONTEXT_RESET) : static_cast<GLenum>(GL_NO_ERROR);
}

Function replaced(const char* name) {
  const auto is = [&](const char* other) { return std::strcmp(name, other) == 0; };
  if (is("glDispatchCompute")) return reinterpret_cast<Function>(&dispatch);
  if (is("glDispatchComputeIndirect")) return reinterpret_cast<Function>(&dispatch_indirect);
  if (is("glBufferData")) return reinterpret_cast<Function>(&buffer_data);
  if (is("glBufferStorage")) return reinterpret_cast<Function>(&buffer_storage);
  if (is("glGetError")) return reinterpret_cast<Function>(&get_error);
  if (is("glLinkProgram")) return reinterpret_cast<Function>(&link_program);
  if (is("glGetProgramiv")) return reinterpret_cast<Function>(&get_program);
  if (is("glGetBufferSubData")) return reinterpret_cast<Function>(&get_buffer);
  if (is("glGetGraphicsResetStatus")) return reinterpret_cast<Function>(&reset_status);
  return get_proc(name);
}

}  // namespace

// The program finds OpenGL's functions by dlsym(), so that is where the others come in.
extern "C" __attribute__((visibility("default"))) void* dlsym(void* handle, const char* name) {
  using Dlsym = void* (*)(void*, const char*);
  static const auto next = [] {
    for (const char* version : {"GLIBC_2.34", "GLIBC_2.17", "GLIBC_2.2.5"})
      if (void* const found = dlvsym(RTLD_NEXT, "dlsym", version)) return reinterpret_cast<Dlsym>(found);
    std::abort();
  }();
  void* const found = next(handle, name);
  if (!found || (std::strcmp(name, "OSMesaGetProcAddress") != 0 && std::strcmp(name, "eglGetProcAddress") != 0))
    return found;
  get_proc = reinterpret_cast<GetProc>(found);
  return reinterpret_cast<void*>(&replaced);
}
