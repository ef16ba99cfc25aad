// The OpenGL 4.3 context that simulations compute in: one of the library's own, or the caller's.
//
// OpenGL contexts belong to a thread, and the library keeps one table of OpenGL's functions: call it from one thread at
// a time, and use a context and its simulations on the thread that made it.
#pragma once
#include <memory>
#include <string>

#include "fascia/export.h"

namespace fascia {
FASCIA_INLINE namespace api {
  /// A handle: copies are the same context. It lives as long as a handle or a simulation does. Simulations of one
  /// context share compiled kernels, so a program that makes several simulations makes one context and hands it to all
  /// of them.
  class FASCIA_EXPORT Context {
   public:
    /// A context without a window. `kind`: "egl", "osmesa" (Mesa's software renderer), or "auto": EGL on a GPU, else
    /// OSMesa, else EGL on software. Every call of a simulation makes it current on the calling thread and leaves it
    /// so: a program that uses OpenGL itself makes its own context current again afterwards, or uses current(). Throws
    /// Error that says what was tried and why each failed.
    static Context own(const std::string& kind = "auto");

    using GetProc = void* (*)(const char* name);
    /// The caller's context, which is current now and must be current in every call of its simulations, their
    /// destruction included. They change its bindings of programs, buffers and buffer textures, nothing else.
    /// `get_proc` finds OpenGL's functions by name; null: that of EGL, GLX or OSMesa, whichever has a context current.
    /// Throws Error where there is none, or where it lacks OpenGL 4.3.
    static Context current(GetProc get_proc = nullptr);

    /// No OpenGL at all: for simulations by the reference solver (OpenOptions::reference).
    static Context none();

    std::string kind() const;      // "egl", "osmesa", "current", "none"
    std::string renderer() const;  // "llvmpipe (LLVM 15.0.6, 256 bits)"; "" for none()
    bool software() const;         // computed by the CPU

    struct FASCIA_HIDDEN Impl;  // the library's own
    const std::shared_ptr<Impl>& impl() const { return impl_; }

   private:
    FASCIA_HIDDEN explicit Context(std::shared_ptr<Impl> impl);
    std::shared_ptr<Impl> impl_;
  };

  /// The folder with the shaders and the shipped scenes, in which paths "assets:..." of scenes lie: that of
  /// set_data_dir(), else the environment's FASCIA_DATA_DIR, else share/fascia of the prefix that the library is
  /// installed in. Throws Error where there is none.
  FASCIA_EXPORT std::string data_dir();
  /// For contexts that are made from now on. Throws Error where `folder` holds no shaders.
  FASCIA_EXPORT void set_data_dir(const std::string& folder);

}  // namespace api
}  // namespace fascia
