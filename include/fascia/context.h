// The OpenGL 4.3 context that simulations compute in: a context of the library or one of the caller.
//
// An OpenGL context belongs to one thread, and the library keeps one table of OpenGL's functions. Call the library from
// one thread at a time. Use a context and its simulations on the thread that made the context.
#pragma once
#include <memory>
#include <string>

#include "fascia/export.h"

namespace fascia {
FASCIA_INLINE namespace api {
  /// A handle to an OpenGL context. Copies refer to the same context. The context lives as long as a handle or a
  /// simulation of it does. Simulations of one context share compiled kernels; a program that makes several simulations
  /// makes one context and passes it to all of them.
  class FASCIA_EXPORT Context {
   public:
    /// Makes a context without a window. `kind` is "egl", "osmesa" (Mesa's software renderer) or "auto". "auto" takes
    /// EGL on a GPU, else OSMesa, else EGL on software. Every call of a simulation makes the context current on the
    /// calling thread and leaves it current. A program that uses OpenGL itself makes its own context current again
    /// afterwards, or uses current(). Throws Error if no context can be made; the message lists what was tried and why
    /// each attempt failed.
    static Context own(const std::string& kind = "auto");

    /// The type of a function that returns the address of the OpenGL function `name`.
    using GetProc = void* (*)(const char* name);
    /// Adopts the caller's context that is current on this thread. It must be current in every call of its simulations,
    /// their destruction included. The simulations change the context's bindings of programs, buffers and buffer
    /// textures, and nothing else. `get_proc` finds OpenGL's functions by name. If it is null, the library takes the
    /// function of EGL, GLX or OSMesa, whichever has a context current. Throws Error if no context is current, or if
    /// the context does not have OpenGL 4.3.
    static Context current(GetProc get_proc = nullptr);

    /// Makes a context without OpenGL, for simulations by the reference solver (OpenOptions::reference). It throws
    /// nothing.
    static Context none();

    /// Returns "egl", "osmesa", "current" or "none".
    std::string kind() const;
    /// Returns the name of the renderer, for example "llvmpipe (LLVM 15.0.6, 256 bits)". It is empty for none().
    std::string renderer() const;
    /// Returns true if the CPU computes what OpenGL is asked for.
    bool software() const;

    struct FASCIA_HIDDEN Impl;  // the library's own
    const std::shared_ptr<Impl>& impl() const { return impl_; }

   private:
    FASCIA_HIDDEN explicit Context(std::shared_ptr<Impl> impl);
    std::shared_ptr<Impl> impl_;
  };

  /// Returns the folder with the shaders and the shipped scenes. Paths "assets:..." of scenes start there. The folder
  /// is that of set_data_dir(), else the environment variable FASCIA_DATA_DIR, else share/fascia of the prefix in which
  /// the library is installed. Throws Error if none of them holds shaders; the message lists them.
  FASCIA_EXPORT std::string data_dir();
  /// Sets the data folder for contexts that are made afterwards. Throws Error if `folder` holds no shaders.
  FASCIA_EXPORT void set_data_dir(const std::string& folder);

}  // namespace api
}  // namespace fascia
