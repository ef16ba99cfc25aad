// EGL without a window: first every device (a server has its GPU there), then Mesa's surfaceless platform. The library
// is opened at run time, so that fascia starts without it.
#define EGL_NO_X11
#define EGL_EGLEXT_PROTOTYPES  // declarations only: nothing links to them
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <dlfcn.h>

#include <array>
#include <cstdio>

#include "base/error.h"
#include "gl/context/context.h"
#include "gl/loader.h"

namespace fascia {
namespace {

struct EglLibrary {
  decltype(&::eglGetProcAddress) get_proc;
// clang-format off
#define FASCIA_EGL_FUNCTIONS(X) \
  X(BindAPI) X(ChooseConfig) X(CreateContext) X(CreatePbufferSurface) X(DestroyContext) X(DestroySurface) \
  X(GetCurrentContext) X(GetError) X(Initialize) X(MakeCurrent) X(QueryString)
// clang-format on
#define X(name) decltype(&::egl##name) name;
  FASCIA_EGL_FUNCTIONS(X)
#undef X
  decltype(&::eglGetPlatformDisplayEXT) get_platform_display;
  decltype(&::eglQueryDevicesEXT) query_devices;             // null without EGL_EXT_device_enumeration
  decltype(&::eglQueryDeviceStringEXT) query_device_string;  // null without EGL_EXT_device_query
};

bool has_word(const char* list, const std::string& word) {
  return list && (" " + std::string(list) + " ").find(" " + word + " ") != std::string::npos;
}

/// Opened once and never closed: drivers do not support unloading.
const EglLibrary& egl() {
  static const EglLibrary opened = [] {
    void* handle = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
    if (!handle) throw Error("egl", std::string("cannot open it: ") + dlerror(), "expected the package libegl1");
    EglLibrary lib{};
    const auto symbol = [&](auto& function, const char* name) {
      function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(dlsym(handle, name));
      if (!function) throw Error("egl", std::string("no function ") + name, "expected EGL 1.5");
    };
    symbol(lib.get_proc, "eglGetProcAddress");
#define X(name) symbol(lib.name, "egl" #name);
    FASCIA_EGL_FUNCTIONS(X)
#undef X
    lib.get_platform_display =
        reinterpret_cast<decltype(&::eglGetPlatformDisplayEXT)>(lib.get_proc("eglGetPlatformDisplayEXT"));
    if (!lib.get_platform_display) throw Error("egl", "no EGL_EXT_platform_base", "expected EGL 1.5");
    const char* client = lib.QueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    if (has_word(client, "EGL_EXT_device_base") || has_word(client, "EGL_EXT_device_enumeration"))
      lib.query_devices = reinterpret_cast<decltype(&::eglQueryDevicesEXT)>(lib.get_proc("eglQueryDevicesEXT"));
    if (has_word(client, "EGL_EXT_device_base") || has_word(client, "EGL_EXT_device_query"))
      lib.query_device_string =
          reinterpret_cast<decltype(&::eglQueryDeviceStringEXT)>(lib.get_proc("eglQueryDeviceStringEXT"));
    return lib;
  }();
  return opened;
}

/// A device or platform that may provide a context.
struct Candidate {
  std::string name;
  EGLenum platform;
  void* native;
};

/// What EGL knows of it without a context.
EglDevice describe(const Candidate& candidate) {
  EglDevice found;
  found.name = candidate.name;
  if (candidate.platform != EGL_PLATFORM_DEVICE_EXT || !egl().query_device_string) return found;
  const auto device = static_cast<EGLDeviceEXT>(candidate.native);
  const char* const extensions = egl().query_device_string(device, EGL_EXTENSIONS);
  found.software = has_word(extensions, "EGL_MESA_device_software");
  found.nvidia = has_word(extensions, "EGL_NV_device_cuda");
  if (has_word(extensions, "EGL_EXT_device_drm"))
    if (const char* file = egl().query_device_string(device, EGL_DRM_DEVICE_FILE_EXT)) found.file = file;
  return found;
}

std::vector<Candidate> candidates() {
  std::vector<Candidate> found;
  const char* client = egl().QueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  std::array<EGLDeviceEXT, 32> devices{};
  EGLint count = 0;
  if (has_word(client, "EGL_EXT_platform_device") && egl().query_devices &&
      egl().query_devices(static_cast<EGLint>(devices.size()), devices.data(), &count))
    for (EGLint i = 0; i < count; ++i)
      found.push_back({"device " + std::to_string(i), EGL_PLATFORM_DEVICE_EXT, devices[static_cast<std::size_t>(i)]});
  if (has_word(client, "EGL_MESA_platform_surfaceless"))
    found.push_back({"surfaceless", EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY});
  return found;
}

[[noreturn]] void fail(const Candidate& where, const std::string& what) {
  char code[16];
  std::snprintf(code, sizeof code, "0x%x", static_cast<unsigned>(egl().GetError()));
  throw Error("egl " + where.name, what + " (EGL error " + code + ")", "expected an OpenGL 4.3 core context");
}

class EglContext : public Context {
 public:
  explicit EglContext(const Candidate& where) : where_(where) {}
  void create(bool debug) {
    // Displays are shared within the process, so they are never terminated.
    display_ = egl().get_platform_display(where_.platform, where_.native, nullptr);
    if (display_ == EGL_NO_DISPLAY || !egl().Initialize(display_, nullptr, nullptr)) fail(where_, "no display");
    if (!egl().BindAPI(EGL_OPENGL_API)) fail(where_, "no OpenGL");
    const char* extensions = egl().QueryString(display_, EGL_EXTENSIONS);
    const bool surfaceless = has_word(extensions, "EGL_KHR_surfaceless_context");
    EGLConfig config = EGL_NO_CONFIG_KHR;
    if (!surfaceless || !has_word(extensions, "EGL_KHR_no_config_context")) {
      const EGLint wanted[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_NONE};
      EGLint count = 0;
      if (!egl().ChooseConfig(display_, wanted, &config, 1, &count) || count == 0) fail(where_, "no config");
    }
    // A version below 4.3 is created only so that gl::load can report it.
    struct Wish {
      EGLint major, minor, reset;
    };
    for (const Wish& wish : {Wish{4, 3, EGL_LOSE_CONTEXT_ON_RESET}, Wish{4, 3, EGL_NO_RESET_NOTIFICATION},
                             Wish{3, 3, EGL_NO_RESET_NOTIFICATION}}) {
      const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                   wish.major,
                                   EGL_CONTEXT_MINOR_VERSION,
                                   wish.minor,
                                   EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                   EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                   EGL_CONTEXT_OPENGL_DEBUG,
                                   debug ? EGL_TRUE : EGL_FALSE,
                                   EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY,
                                   wish.reset,
                                   EGL_NONE};
      context_ = egl().CreateContext(display_, config, EGL_NO_CONTEXT, attributes);
      if (context_ != EGL_NO_CONTEXT) break;
    }
    if (context_ == EGL_NO_CONTEXT) fail(where_, "no OpenGL core context");
    if (surfaceless) return;
    // Tiny, because all drawing goes to fascia's own framebuffers.
    const EGLint size[] = {EGL_WIDTH, 4, EGL_HEIGHT, 4, EGL_NONE};
    surface_ = egl().CreatePbufferSurface(display_, config, size);
    if (surface_ == EGL_NO_SURFACE) fail(where_, "no pbuffer surface");
  }
  ~EglContext() override {
    if (display_ != EGL_NO_DISPLAY) egl().MakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (surface_ != EGL_NO_SURFACE) egl().DestroySurface(display_, surface_);
    if (context_ != EGL_NO_CONTEXT) egl().DestroyContext(display_, context_);
  }
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  std::string name() const override { return "egl"; }
  bool is_current() const override { return egl().GetCurrentContext() == context_; }
  void make_current() override {
    // Released first: if another library was current in between, EGL still considers its context bound, and binding it
    // again would have no effect.
    egl().MakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    egl().BindAPI(EGL_OPENGL_API);
    if (!egl().MakeCurrent(display_, surface_, surface_, context_)) fail(where_, "the context cannot be made current");
    gl::load([](const char* name) { return reinterpret_cast<void*>(egl().get_proc(name)); });
  }

 private:
  Candidate where_;
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
  EGLSurface surface_ = EGL_NO_SURFACE;
};

}  // namespace

std::vector<EglDevice> list_egl_devices() {
  std::vector<EglDevice> found;
  for (const Candidate& candidate : candidates()) found.push_back(describe(candidate));
  return found;
}

std::vector<EglDevice> egl_devices() {
  std::vector<EglDevice> found;
  for (const Candidate& candidate : candidates()) {
    EglDevice& device = found.emplace_back(describe(candidate));
    try {
      EglContext context(candidate);
      context.create(false);
      context.make_current();
      device.renderer = gl::device().renderer + ", OpenGL " + gl::device().version;
      device.software = gl::device().software;
    } catch (const Error& error) {
      device.refusal = error.what();
    }
  }
  return found;
}

std::unique_ptr<Context> make_egl_context(const ContextRequest& request, EglDevices devices) {
  if (request.device >= 0) {
    const std::string wanted = "device " + std::to_string(request.device);
    for (const Candidate& candidate : candidates()) {
      if (candidate.name != wanted) continue;
      auto context = std::make_unique<EglContext>(candidate);
      context->create(request.debug);
      context->make_current();
      return context;
    }
    throw Error("--device " + std::to_string(request.device), "EGL has no device of this number",
                "expected one that fascia info --device lists");
  }
  std::string tried;
  std::unique_ptr<Context> on_software;  // the first one, used if there is no GPU
  for (const Candidate& candidate : candidates()) {
    try {
      auto context = std::make_unique<EglContext>(candidate);
      context->create(request.debug);
      context->make_current();
      if (!gl::device().software) {
        on_software.reset();  // its end leaves no context current
        context->make_current();
        return context;
      }
      if (!on_software) on_software = std::move(context);
      tried += (tried.empty() ? "" : ", ") + candidate.name + " (" + gl::device().renderer + ")";
    } catch (const Error& error) {
      tried += (tried.empty() ? "" : ", ") + candidate.name + " (" + error.what() + ")";
    }
  }
  if (tried.empty()) tried = "none: neither EGL_EXT_platform_device nor EGL_MESA_platform_surfaceless";
  if (devices == EglDevices::hardware_only)
    throw Error("egl", "no GPU; found " + tried, "expected a hardware renderer");
  if (!on_software) throw Error("egl", "no context; tried " + tried, "expected a device or the surfaceless platform");
  on_software->make_current();
  return on_software;
}

}  // namespace fascia
