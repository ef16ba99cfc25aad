#include "api/context.h"

#include <dlfcn.h>

#include "api/error.h"
#include "base/data_folder.h"

namespace fascia::api {
namespace {

const Context::Impl* loaded = nullptr;  // the context whose functions gl:: has

struct WindowSystem {
  Context::GetProc get_proc = nullptr;
  void* (*get_current)() = nullptr;
};

/// The window system with a current context on this thread; null members if none of the loaded ones has one.
WindowSystem find_window_system() {
  struct Library {
    const char *file, *get_current, *get_proc;
  };
  for (const Library& library : {Library{"libEGL.so.1", "eglGetCurrentContext", "eglGetProcAddress"},
                                 Library{"libGLX.so.0", "glXGetCurrentContext", "glXGetProcAddressARB"},
                                 Library{"libGL.so.1", "glXGetCurrentContext", "glXGetProcAddressARB"},
                                 Library{"libOSMesa.so.8", "OSMesaGetCurrentContext", "OSMesaGetProcAddress"}}) {
    void* handle = dlopen(library.file, RTLD_NOW | RTLD_NOLOAD);
    if (!handle) continue;
    const auto get_current = reinterpret_cast<void* (*)()>(dlsym(handle, library.get_current));
    const auto get_proc = reinterpret_cast<Context::GetProc>(dlsym(handle, library.get_proc));
    const bool current = get_current && get_proc && get_current();
    dlclose(handle);  // the caller keeps it open
    if (current) return {get_proc, get_current};
  }
  return {};
}

}  // namespace

Context::Impl::~Impl() {
  try {
    enter();
  } catch (...) {  // there is nothing to free once the context is gone
  }
  programs.reset();
  if (loaded == this) loaded = nullptr;
}

void Context::Impl::enter() {
  if (!programs) return;
  if (own) {
    if (loaded == this && own->is_current()) return;
    own->make_current();
  } else {
    const bool current = get_current ? get_current() == handle : loaded != this || gl::GetString(GL_VERSION);
    if (!current)
      throw Error("context", "is not current", "expected the OpenGL context that Context::current() was called with");
    if (loaded != this) gl::load(get_proc);
  }
  loaded = this;
}

void Context::Impl::load_kernels() {
  renderer = gl::device().renderer;
  software = gl::device().software;
  programs = std::make_unique<gl::ProgramCache>(std::filesystem::path(data_dir()) / "shaders", gl::fitting_load_path());
  programs->set_fusing(true);
  loaded = this;
}

Context::Context(std::shared_ptr<Impl> impl) : impl_(std::move(impl)) {}

Context Context::own(const std::string& kind) {
  return translated([&] {
    auto impl = std::make_shared<Impl>();
    loaded = nullptr;
    ContextRequest request;
    request.name = kind;
    impl->own = make_headless_context(request);
    impl->kind = impl->own->name();
    impl->load_kernels();
    return Context(std::move(impl));
  });
}

Context Context::current(GetProc get_proc) {
  return translated([&] {
    const WindowSystem system = find_window_system();
    if (!get_proc) get_proc = system.get_proc;
    if (!get_proc)
      throw Error("context", "no OpenGL context is current", "expected one of EGL, GLX or OSMesa on this thread");
    auto impl = std::make_shared<Impl>();
    loaded = nullptr;
    gl::load(get_proc);
    impl->kind = "current";
    impl->get_proc = get_proc;
    impl->get_current = system.get_current;
    impl->handle = system.get_current ? system.get_current() : nullptr;
    impl->load_kernels();
    return Context(std::move(impl));
  });
}

Context Context::none() {
  auto impl = std::make_shared<Impl>();
  impl->kind = "none";
  return Context(std::move(impl));
}

std::string Context::kind() const { return impl_->kind; }
std::string Context::renderer() const { return impl_->renderer; }
bool Context::software() const { return impl_->software; }

std::string data_dir() {
  const std::filesystem::path assets = asset_folder();
  if (assets.empty()) {
    std::string tried;
    for (const std::filesystem::path& folder : data_folders()) tried += (tried.empty() ? "" : ", ") + folder.string();
    throw Error("fascia", "its shaders were not found in " + tried,
                "name their parent folder with FASCIA_DATA_DIR or set_data_dir()");
  }
  return assets.parent_path().string();
}

void set_data_dir(const std::string& folder) {
  if (!holds_shaders(folder))
    throw Error("set_data_dir: " + folder, "has no folder shaders", "expected fascia's data folder");
  set_data_folder(folder);
}

}  // namespace fascia::api
