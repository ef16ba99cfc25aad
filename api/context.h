// What is behind a public context: the OpenGL context, if it is the library's own, and the kernels that its simulations
// share.
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
  std::unique_ptr<fascia::Context> own;        // null: the caller's, or none
  GetProc get_proc = nullptr;                  // of the caller's
  void* (*get_current)() = nullptr;            // the window system's name of the context that is current; null: unknown
  void* handle = nullptr;                      // what that was for the caller's
  std::unique_ptr<gl::ProgramCache> programs;  // null: none

  Impl() = default;
  ~Impl();
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  /// Makes it current, if it is the library's own, and points the gl:: functions at it. Throws Error where the caller's
  /// is not current.
  void enter();
  void load_kernels();
};

}  // namespace fascia::api
