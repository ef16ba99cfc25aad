// Tissue in a program with its own OpenGL context and loop: drawn directly from the solver's buffer. The context here
// is EGL's without a window, so that the example runs anywhere; a program with a window differs in `Screen` only.
#define GL_GLEXT_PROTOTYPES
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/glcorearb.h>

#include <algorithm>
#include <cstdio>
#include <stdexcept>

#include "fascia/fascia.h"

namespace {

constexpr int kSize = 64;  // of the picture, in pixels

/// A current OpenGL 4.3 context, with a picture to draw into.
struct Screen {
  Screen() {
    EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION, 4, EGL_CONTEXT_MINOR_VERSION, 3, EGL_NONE};
    if (!eglInitialize(display, nullptr, nullptr) || !eglBindAPI(EGL_OPENGL_API))
      throw std::runtime_error("no EGL display");
    EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, version);
    if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) throw std::runtime_error("no OpenGL 4.3");
    GLuint texture, framebuffer, vertex_array;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kSize, kSize, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    glGenVertexArrays(1, &vertex_array);
    glBindVertexArray(vertex_array);
    glViewport(0, 0, kSize, kSize);
  }
};

GLuint make_program() {
  const char* sources[] = {
      "#version 430\nlayout(location = 0) in vec4 x; void main() { gl_Position = vec4(10 * x.xy - 1, 0, 1); }",
      "#version 430\nout vec4 color; void main() { color = vec4(0.8, 0.3, 0.3, 1); }"};
  const GLuint program = glCreateProgram();
  for (int i = 0; i < 2; ++i) {
    const GLuint shader = glCreateShader(i == 0 ? GL_VERTEX_SHADER : GL_FRAGMENT_SHADER);
    glShaderSource(shader, 1, &sources[i], nullptr);
    glCompileShader(shader);
    glAttachShader(program, shader);
  }
  glLinkProgram(program);
  return program;
}

/// The lowest and the highest row with a drawn pixel.
std::pair<int, int> drawn_rows() {
  std::vector<unsigned char> pixels(4 * kSize * kSize);
  glReadPixels(0, 0, kSize, kSize, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  std::pair<int, int> rows{kSize, -1};
  for (int i = 0; i < kSize * kSize; ++i)
    if (pixels[static_cast<std::size_t>(4 * i)] > 0)
      rows = {std::min(rows.first, i / kSize), std::max(rows.second, i / kSize)};
  return rows;
}

}  // namespace

int main() try {
  const Screen screen;
  const GLuint program = make_program();
  fascia::Scene scene;  // a cube in the middle of the picture, which is 0.2 m wide
  scene.bodies.push_back({.mesh = fascia::make_box(4, 4, 4, {0.1, 0.1, 0.1})});
  for (std::size_t i = 0; i < scene.bodies[0].mesh.positions.size(); ++i)
    scene.bodies[0].mesh.positions[i] += i % 3 == 1 ? 0.1 : 0.05;
  fascia::Simulation simulation(scene, fascia::Context::current());
  const std::span<const std::uint32_t> triangles = simulation.surface_triangles();
  GLuint index_buffer;
  glGenBuffers(1, &index_buffer);
  for (int frame = 0; frame <= 6; ++frame) {
    if (frame > 0) simulation.step();
    // Calls of the simulation change the bound program and buffers
    const GLuint positions = simulation.position_buffer();
    glUseProgram(program);
    glBindBuffer(GL_ARRAY_BUFFER, positions);
    glVertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, 0, nullptr);
    glEnableVertexAttribArray(0);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, index_buffer);
    if (frame == 0)
      glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(triangles.size_bytes()), triangles.data(),
                   GL_STATIC_DRAW);
    glClear(GL_COLOR_BUFFER_BIT);
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(triangles.size()), GL_UNSIGNED_INT, nullptr);
    const auto [low, high] = drawn_rows();
    std::printf("frame_%d %d %d\n", frame, low, high);
  }
  std::printf("errors %d\n", static_cast<int>(glGetError()));
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
