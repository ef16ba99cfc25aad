// Contexts of every kind, alone and together. Tests that need another environment (no display, an X server, an older
// OpenGL) run in a second process of this test program, as a test case that is hidden from normal runs.
// Covers: context_glfw, gl/context/context_egl, gl/context/context_osmesa, gl/context/headless_context
#include "render/context/context.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "gl/compute_pass.h"
#include "render/target/framebuffer.h"
#include "tests/gl/gl_support.h"

namespace fascia {
namespace {

using Catch::Matchers::Contains;
using test::error_of;

constexpr const char* kSquare =
    "#include \"common/io.glsl\"\nINPUT_FLOAT(Value, value)\nOUTPUT(float, Square, square)\nCOMPUTE_1D\n"
    "void main() {\n  ITEM_OR_RETURN(i)\n  square[i] = FETCH1(value, i) * FETCH1(value, i);\n}\n";

/// Everything that a context needs to compute; created and destroyed with its context current.
struct Kernel {
  test::ShaderFolder folder;
  gl::ProgramCache programs{folder.path(), gl::LoadPath::texel};
  gl::Buffer value{"value", std::vector<float>{1.5f, 3.0f}}, square{"square", 8};
  std::unique_ptr<gl::ComputePass> pass;
  Kernel() {
    folder.write("square.comp", kSquare);
    pass = std::make_unique<gl::ComputePass>(programs.compute("square.comp"),
                                             gl::ComputePass::Bindings{{"value", &value}, {"square", &square}}, 2);
  }
  std::vector<float> run() const {
    pass->run();
    return square.read<float>();
  }
};
const std::vector<float> kSquares = {2.25f, 9.0f};

test::CommandResult run_hidden(const std::vector<std::string>& launcher, const std::string& test_case) {
  std::vector<std::string> command = launcher;
  command.push_back(std::filesystem::read_symlink("/proc/self/exe"));
  command.push_back(test_case);
  return test::run_command(command);
}

}  // namespace

TEST_CASE("OSMesa and EGL work side by side in one process") {
  const auto osmesa = make_osmesa_context({});
  auto a = std::make_unique<Kernel>();
  CHECK(a->run() == kSquares);
  const auto egl = make_egl_context({}, EglDevices::any);
  auto b = std::make_unique<Kernel>();
  CHECK(b->run() == kSquares);
  for (int i = 0; i < 3; ++i) {
    osmesa->make_current();
    a->value.upload(0, 4, std::vector<float>{static_cast<float>(i)}.data());
    CHECK(a->run() == std::vector<float>{static_cast<float>(i * i), 9.0f});
    CHECK(gl::GetError() == GL_NO_ERROR);
    egl->make_current();
    CHECK(b->run() == kSquares);
    CHECK(gl::GetError() == GL_NO_ERROR);
  }
  osmesa->make_current();
  a.reset();
  egl->make_current();
  b.reset();
}

TEST_CASE("two contexts of the same kind work side by side") {
  const auto first = test::each_context();
  auto a = std::make_unique<Kernel>();
  {
    const auto second = make_context({.name = first->name(), .title = ""});
    const Kernel b;
    CHECK(b.run() == kSquares);
  }
  first->make_current();  // the end of the other context does not affect this one
  CHECK(a->run() == kSquares);
  a.reset();
}

TEST_CASE("contexts are made by name") {
  CHECK(make_context({.name = "osmesa", .title = ""})->name() == "osmesa");
  CHECK(make_context({.name = "egl", .title = "", .debug = true})->name() == "egl");
  const auto chosen = make_context({});
  CAPTURE(gl::device().renderer);
  CHECK(chosen->name() == (gl::device().software ? "osmesa" : "egl"));
  CHECK(chosen->window() == nullptr);
  CHECK(error_of([] { make_context({.name = "vulkan", .title = ""}); }) ==
        "context vulkan: unknown; expected auto, window, egl or osmesa");
}

TEST_CASE("EGL reports the renderers that it found if no GPU is among them") {
  try {
    make_egl_context({}, EglDevices::hardware_only);
    CHECK_FALSE(gl::device().software);
  } catch (const Error& error) {
    CHECK_THAT(error.what(), Contains("egl: no GPU; found ") && Contains("surfaceless"));
  }
}

TEST_CASE("hidden: no display", "[.]") {
  CHECK_THAT(
      error_of([] { make_context({.for_view = true, .title = ""}); }),
      Contains("window: no display: ") && Contains("expected a graphical session") && Contains("--context osmesa"));
}

TEST_CASE("a window without a display is a clear error") {
  const auto child = run_hidden({"env", "-u", "DISPLAY", "-u", "WAYLAND_DISPLAY"}, "hidden: no display");
  INFO(child.out << child.err);
  CHECK(child.exit_code == 0);
}

TEST_CASE("hidden: old OpenGL", "[.]") {
  for (const char* name : {"osmesa", "egl"}) {
    const std::string message = error_of([&] { make_context({.name = name, .title = ""}); });
    CHECK_THAT(message, Contains("OpenGL: found version 4.1") && Contains("missing: version 4.3 with compute shaders"));
  }
  CHECK_THAT(error_of([] { make_context({}); }),
             Contains("context auto: no OpenGL 4.3 context; tried EGL on a GPU (") && Contains(", OSMesa (") &&
                 Contains(", EGL on software ("));
}

TEST_CASE("OpenGL 4.1 is refused with the version that was found") {
  const auto child = run_hidden({"env", "MESA_GL_VERSION_OVERRIDE=4.1"}, "hidden: old OpenGL");
  INFO(child.out << child.err);
  CHECK(child.exit_code == 0);
}

TEST_CASE("hidden: window", "[.]") {
  const auto context = make_context({.for_view = true, .width = 64, .height = 48, .title = "test", .debug = true});
  CHECK(context->name() == "window");
  REQUIRE(context->window() != nullptr);
  auto kernel = std::make_unique<Kernel>();
  CHECK(kernel->run() == kSquares);
  {
    const Framebuffer framebuffer(64, 48, 4);
    framebuffer.bind();
    gl::ClearColor(1, 0.5f, 0, 1);
    gl::Clear(GL_COLOR_BUFFER_BIT);
    framebuffer.resolve();
    framebuffer.present(64, 48);
    gl::BindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    std::uint8_t pixel[4] = {};
    gl::ReadPixels(10, 10, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    CHECK((pixel[0] == 255 && pixel[1] / 2 == 64 && pixel[2] == 0));  // 0.5 may round to 127 or 128
    glfwSwapBuffers(context->window());
  }
  {
    const auto osmesa = make_osmesa_context({});
    const Kernel other;
    CHECK(other.run() == kSquares);
  }
  context->make_current();
  CHECK(kernel->run() == kSquares);
  CHECK(gl::GetError() == GL_NO_ERROR);
  kernel.reset();
}

TEST_CASE("hidden: window of a device", "[.]") {
  CHECK(error_of([] { make_context({.for_view = true, .title = "", .device = 31}); }) ==
        "--device 31: EGL has no device of this number; expected one that fascia info --device lists");
  const std::vector<EglDevice> devices = list_egl_devices();
  for (std::size_t i = 0; i < devices.size(); ++i) {
    CAPTURE(devices[i].name, devices[i].file);
    if (!devices[i].software) continue;  // whether a display lets a GPU draw its windows is the system's choice
    const auto context = make_context({.for_view = true, .width = 64, .height = 48, .title = "", .device = int(i)});
    CHECK(context->name() == "window");
    CHECK(context->is_current());
    CHECK(gl::device().software);
    CHECK(context->other_device.empty());
    CHECK(std::getenv("LIBGL_ALWAYS_SOFTWARE") == std::string("1"));
    const Kernel kernel;
    CHECK(kernel.run() == kSquares);
  }
}

TEST_CASE("a software renderer that --device names draws a window") {
  const auto child = run_hidden({"xvfb-run", "-a", "env", "-u", "WAYLAND_DISPLAY", "-u", "LIBGL_ALWAYS_SOFTWARE"},
                                "hidden: window of a device");
  INFO(child.out << child.err);
  CHECK(child.exit_code == 0);
}

TEST_CASE("a window computes and shows pictures") {
  const auto child = run_hidden({"xvfb-run", "-a", "env", "-u", "WAYLAND_DISPLAY"}, "hidden: window");
  INFO(child.out << child.err);
  CHECK(child.exit_code == 0);
}

}  // namespace fascia
