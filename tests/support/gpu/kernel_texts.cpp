#include "tests/support/gpu/kernel_texts.h"

#include <algorithm>
#include <cctype>
#include <sstream>

#include "gl/program.h"
#include "tests/support/gpu/kernel_cases.h"
#include "tests/support/gpu/swapped.h"
#include "tests/support/support.h"

namespace fascia::test {
namespace {

struct Seen {
  std::map<GLuint, std::string> text;  // of a shader
  std::map<GLuint, GLuint> shader;     // of a program: the last one
  std::map<KernelName, std::string> kernels;
  GLuint program = 0;  // in use
  GLuint probe = 0;    // the program by which the solver finds out whether the device computes
};

Seen* seen = nullptr;
decltype(gl::ShaderSource) shader_source;
decltype(gl::AttachShader) attach_shader;
decltype(gl::ObjectLabel) object_label;
decltype(gl::UseProgram) use_program;
decltype(gl::DispatchCompute) dispatch;

/// The defines of a text whose value is not 0, apart from those that hold code and those that all kernels have.
std::string variant_of(const std::string& text) {
  std::istringstream in(text);
  std::string line, variant;
  std::getline(in, line);  // #version
  while (std::getline(in, line) && line.starts_with("#define ")) {
    std::istringstream words(line.substr(8));
    std::string name, value;
    words >> name >> value;
    const bool code = name.find('(') != std::string::npos;
    if (code || value == "0" || name == "TEXELS_IN_ORDER" || name == "SUMS_IN_GROUPS" || name == "LAW_COUNT" ||
        name == "BEYOND_STRAIN")
      continue;
    for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    variant += (variant.empty() ? "" : " ") + name + (value == "1" ? "" : "=" + value);
  }
  return variant;
}

void take_label(GLenum kind, GLuint id, GLsizei length, const GLchar* label) {
  object_label(kind, id, length, label);
  if (kind != GL_PROGRAM) return;
  std::string file(label, static_cast<std::size_t>(length));
  file.resize(std::min(file.find(' '), file.size()));
  if (!file.ends_with(".comp")) return;
  if (file == "common/fill.comp") seen->probe = id;
  const std::string& text = seen->text.at(seen->shader.at(id));
  seen->kernels.emplace(KernelName(file, variant_of(text)), text);
}

}  // namespace

std::map<KernelName, std::string> kernel_texts() {
  Seen all;
  seen = &all;
  shader_source = gl::ShaderSource;
  attach_shader = gl::AttachShader;
  object_label = gl::ObjectLabel;
  use_program = gl::UseProgram;
  dispatch = gl::DispatchCompute;
  const Swapped source(
      gl::ShaderSource, +[](GLuint shader, GLsizei count, const GLchar* const* text, const GLint* lengths) {
        seen->text[shader] = text[0];
        shader_source(shader, count, text, lengths);
      });
  const Swapped attach(
      gl::AttachShader, +[](GLuint program, GLuint shader) {
        seen->shader[program] = shader;
        attach_shader(program, shader);
      });
  const Swapped label(gl::ObjectLabel, &take_label);
  const Swapped use(
      gl::UseProgram, +[](GLuint program) {
        seen->program = program;
        use_program(program);
      });
  const Swapped dispatches(
      gl::DispatchCompute, +[](GLuint x, GLuint y, GLuint z) {
        if (seen->program == seen->probe) dispatch(x, y, z);
      });
  const Swapped indirect(
      gl::DispatchComputeIndirect, +[](GLintptr) {});
  gl::ProgramCache programs(source_dir() / "shaders", gl::LoadPath::storage, gl::Sums::in_groups);
  for (const KernelCase& example : kernel_cases()) run_all(example, programs);
  programs.compute("draw/normals.comp");
  return all.kernels;
}

}  // namespace fascia::test
