// OSMesa: Mesa's software renderer without any window system. The library is opened at run time, and the few
// declarations of its header are repeated here, so that neither building nor starting fascia needs it.
#include <dlfcn.h>

#include <array>
#include <cstdint>

#include "base/error.h"
#include "gl/context/context.h"
#include "gl/loader.h"

#ifdef __SANITIZE_ADDRESS__
// OSMesa keeps a few hundred bytes of every destroyed context; that must not hide leaks of fascia.
extern "C" __attribute__((visibility("default"))) const char* __lsan_default_suppressions() {
  return "leak:libOSMesa.so\n";
}
#endif

namespace fascia {
namespace {

constexpr int kRgba = GL_RGBA, kFormat = 0x22, kDepthBits = 0x30, kProfile = 0x33, kCoreProfile = 0x34, kMajor = 0x36,
              kMinor = 0x37;

struct OsMesaLibrary {
  using Handle = void*;
  Handle (*create)(const int* attributes, Handle share);
  void (*destroy)(Handle);
  GLboolean (*make_current)(Handle, void* buffer, GLenum type, GLsizei width, GLsizei height);
  Handle (*get_current)();
  void* (*get_proc)(const char* name);
};

/// Opened once and never closed: drivers do not support unloading.
const OsMesaLibrary& library() {
  static const OsMesaLibrary opened = [] {
    void* handle = dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL);
    if (!handle) throw Error("osmesa", std::string("cannot open it: ") + dlerror(), "expected the package libosmesa6");
    OsMesaLibrary lib{};
    const auto symbol = [&](auto& function, const char* name) {
      function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(dlsym(handle, name));
      if (!function) throw Error("osmesa", std::string("no function ") + name, "expected OSMesa 12 or later");
    };
    symbol(lib.create, "OSMesaCreateContextAttribs");
    symbol(lib.destroy, "OSMesaDestroyContext");
    symbol(lib.make_current, "OSMesaMakeCurrent");
    symbol(lib.get_current, "OSMesaGetCurrentContext");
    symbol(lib.get_proc, "OSMesaGetProcAddress");
    return lib;
  }();
  return opened;
}

class OsmesaContext : public Context {
 public:
  OsmesaContext(int major, int minor) {
    const int attributes[] = {kFormat, kRgba, kDepthBits, 0, kProfile, kCoreProfile, kMajor, major, kMinor, minor, 0};
    handle_ = library().create(attributes, nullptr);
  }
  ~OsmesaContext() override {
    if (handle_) library().destroy(handle_);
  }
  OsmesaContext(const OsmesaContext&) = delete;
  OsmesaContext& operator=(const OsmesaContext&) = delete;

  bool valid() const { return handle_ != nullptr; }
  std::string name() const override { return "osmesa"; }
  bool is_current() const override { return library().get_current() == handle_; }
  void make_current() override {
    // Released first: if EGL was current in between, OSMesa still considers its context bound, and binding it again
    // would have no effect.
    library().make_current(nullptr, nullptr, 0, 0, 0);
    if (!library().make_current(handle_, surface_.data(), GL_UNSIGNED_BYTE, kSize, kSize))
      throw Error("osmesa", "the context cannot be made current", "expected a working OSMesa");
    gl::load(library().get_proc);
  }

 private:
  static constexpr int kSize = 4;  // all drawing goes to fascia's own framebuffers
  std::array<std::uint32_t, kSize * kSize> surface_{};
  OsMesaLibrary::Handle handle_ = nullptr;
};

}  // namespace

std::unique_ptr<Context> make_osmesa_context(const ContextRequest&) {
  auto context = std::make_unique<OsmesaContext>(4, 3);
  // A version below 4.3 is created only so that gl::load can report it.
  if (!context->valid()) context = std::make_unique<OsmesaContext>(3, 3);
  if (!context->valid()) throw Error("osmesa", "no OpenGL core context", "expected OpenGL 4.3");
  context->make_current();
  return context;
}

}  // namespace fascia
