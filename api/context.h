// The implementation of a public context: the OpenGL context, if the library owns it, and the kernels that its
// simulations share.
#pragma once
#include <memory>
#include <string>

#include "fascia/context.h"
#include "gl/context/context.h"
#include "gl/program.h"

namespace fascia::api {

struct Context::Impl {
  std::string kind, renderer;
  bool software = false;
  std::unique_ptr<fascia::Context> own;  // null: the caller's, or none
  GetProc get_proc = nullptr;            // the caller's function
  void* (*get_current)() = nullptr;      // returns the window system's handle of the current context; null: unknown
  void* handle = nullptr;                // that handle for the caller's context
  std::unique_ptr<gl::ProgramCache> programs;  // null: none

  Impl() = default;
  ~Impl();
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  /// Makes the context current, if the library owns it, and points the gl:: functions at it. Throws Error if the
  /// caller's context is not current.
  void enter();
  void load_kernels();
};

}  // namespace fascia::api
