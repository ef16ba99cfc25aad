// Compiles compute kernels with the OpenGL driver of an Intel chip, such as idle_i915.cpp presents; prints what
// Mesa states of their code in debug messages.
//   intel_figures FILE.comp...
// The first line is the driver's version, the others are FILE,WIDTH,INSTRUCTIONS,SPILLS,FILLS: invocations that an
// instruction computes at once (SIMD8, 16 or 32), and stores and loads of registers that do not fit.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "base/error.h"
#include "base/file.h"
#include "gl/context/context.h"
#include "gl/loader.h"

namespace {

namespace gl = fascia::gl;

std::string statement;  // the last one

void APIENTRY take(GLenum, GLenum, GLuint, GLenum, GLsizei, const GLchar* text, const void*) {
  if (std::strncmp(text, "CS SIMD", 7) == 0) statement = text;
}

void print_figures(const char* file) {
  const std::string text = fascia::read_file(file);
  const GLchar* const source = text.c_str();
  const GLuint shader = gl::CreateShader(GL_COMPUTE_SHADER), program = gl::CreateProgram();
  gl::ShaderSource(shader, 1, &source, nullptr);
  gl::CompileShader(shader);
  gl::AttachShader(program, shader);
  statement.clear();
  gl::LinkProgram(program);
  GLint linked = 0;
  gl::GetProgramiv(program, GL_LINK_STATUS, &linked);
  char log[2000] = "";
  gl::GetProgramInfoLog(program, sizeof log, nullptr, log);
  if (!linked) throw fascia::Error(file, "does not link", log);
  gl::UseProgram(program);
  gl::DispatchCompute(1, 1, 1);  // at the latest, the code is made now
  int width = 0, instructions = 0, spills = 0, fills = 0;
  if (std::sscanf(statement.c_str(), "CS SIMD%d shader: %d inst, %*d loops, %*u cycles, %d:%d spills:fills", &width,
                  &instructions, &spills, &fills) != 4)
    throw fascia::Error(file, "no figures in \"" + statement + "\"", "expected a message of Mesa's driver for Intel");
  std::printf("%s,%d,%d,%d,%d\n", file, width, instructions, spills, fills);
  gl::DeleteShader(shader);
  gl::DeleteProgram(program);
}

}  // namespace

int main(int count, char** files) try {
  fascia::ContextRequest request;
  request.debug = true;
  const auto context = fascia::make_egl_context(request, fascia::EglDevices::any);
  const std::string &renderer = gl::device().renderer, &version = gl::device().version;
  const std::size_t mesa = version.find("Mesa");
  std::printf("%s\n", mesa == std::string::npos ? version.c_str() : version.substr(mesa).c_str());
  if (renderer.find("Intel") == std::string::npos) {
    std::fprintf(stderr, "intel_figures: found %s\n", renderer.c_str());
    return 1;
  }
  gl::Enable(GL_DEBUG_OUTPUT);
  gl::DebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_DONT_CARE, 0, nullptr, GL_TRUE);
  gl::DebugMessageCallback(take, nullptr);
  for (int i = 1; i < count; ++i) print_figures(files[i]);
} catch (const fascia::Error& error) {
  std::fprintf(stderr, "intel_figures: %s\n", error.what());
  return 1;
}
