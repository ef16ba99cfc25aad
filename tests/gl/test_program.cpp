#include "gl/program.h"

#include <thread>

#include "gl/buffer.h"
#include "gl/compute_pass.h"
#include "tests/gl/gl_support.h"

namespace fascia::gl {
namespace {

using Catch::Matchers::Contains;
using test::error_of;

constexpr const char* kFill =
    "#include \"common/io.glsl\"\n#include \"value.glsl\"\nOUTPUT(float, Result, result)\nCOMPUTE_1D\n"
    "void main() {\n  ITEM_OR_RETURN(i)\n  result[i] = value();\n}\n";

float filled(const Program& program) {
  const Buffer result("result", 4);
  ComputePass(program, {{"result", &result}}, 1).run();
  return result.read<float>()[0];
}

}  // namespace

TEST_CASE("a compile error is mapped through an include and names the variant") {
  const auto context = test::each_context();
  const test::ShaderFolder folder;
  folder.write("fill.comp", kFill);
  folder.write("value.glsl", "// first\nfloat value() {\n  return wrong_name;\n}\n");
  ProgramCache programs(folder.path(), LoadPath::storage);
  const std::string message = error_of([&] { programs.compute("fill.comp", {{"SECOND", "2"}, {"FIRST", "1"}}); });
  CHECK_THAT(message, Contains("shaders/value.glsl:3: ") && Contains("wrong_name"));
  CHECK_THAT(message, Contains("fill.comp [FIRST=1 SECOND=2]"));
  CHECK(message.find('\n') == std::string::npos);
  CHECK(programs.size() == 0);
  folder.write("value.glsl", "float value() { return 1.0; }\n");  // repaired: the failure is not cached
  CHECK(filled(programs.compute("fill.comp", {{"SECOND", "2"}, {"FIRST", "1"}})) == 1.0f);
}

TEST_CASE("a program is linked in parallel, and reports errors when it is used") {
  const auto context = test::each_context();
  const test::ShaderFolder folder;
  folder.write("fill.comp", kFill);
  folder.write("value.glsl", "float value() { return float(VALUE); }\n");
  ProgramCache programs(folder.path(), LoadPath::storage);
  const auto postponed = [&](const char* value) -> const Program& {
    const ProgramCache::Postponed postpones(programs);
    return programs.compute("fill.comp", {{"VALUE", value}});
  };
  const Program &right = postponed("7"), &wrong = postponed("nothing");
  CHECK((right.idle() && wrong.idle()));
  right.begin_link();
  wrong.begin_link();
  CHECK(programs.size() == 0);
  while (!right.idle() || !wrong.idle()) std::this_thread::yield();
  const std::string message = error_of([&] { wrong.require(); });
  CHECK_THAT(message,
             Contains("shaders/value.glsl:1: ") && Contains("nothing") && Contains("fill.comp [VALUE=nothing]"));
  CHECK(filled(right) == 7);
  CHECK(programs.size() == 1);
  folder.write("value.glsl", "float value() { return 3.0; }\n");
  CHECK(filled(wrong) == 3);
  CHECK(GetError() == GL_NO_ERROR);
}

TEST_CASE("a link error names the program") {
  const auto context = test::each_context();
  const test::ShaderFolder folder;
  folder.write("a.vert", "out vec4 tint;\nvoid main() { tint = vec4(1); gl_Position = vec4(0); }\n");
  folder.write("a.frag", "in vec2 tint;\nout vec4 color;\nvoid main() { color = tint.xyxy; }\n");
  ProgramCache programs(folder.path(), LoadPath::storage);
  const std::string message = error_of([&] { programs.draw("a.vert", "a.frag"); });
  CHECK_THAT(message, Contains("a.vert + a.frag: does not link: ") && Contains("tint"));
  CHECK(message.find('\n') == std::string::npos);
  folder.write("a.frag", "in vec4 tint;\nout vec4 color;\nvoid main() { color = tint; }\n");
  CHECK(programs.draw("a.vert", "a.frag").id() != 0);
}

TEST_CASE("more storage blocks than the device has do not link") {
  const auto context = test::each_context();
  const test::ShaderFolder folder;
  std::string text = "#include \"common/io.glsl\"\nCOMPUTE_1D\n", body;
  for (int i = 0; i <= device().max_compute_storage_blocks; ++i) {
    const std::string n = std::to_string(i);
    text += "OUTPUT(float, Result" + n + ", result_" + n + ")\n";
    body += "  result_" + n + "[i] = 1.0;\n";
  }
  folder.write("many.comp", text + "void main() {\n  ITEM_OR_RETURN(i)\n" + body + "}\n");
  ProgramCache programs(folder.path(), LoadPath::storage);
  CHECK_THAT(error_of([&] { programs.compute("many.comp"); }), Contains("many.comp"));
}

TEST_CASE("variants are cached by their defines, in any order") {
  const auto context = test::each_context();
  const test::ShaderFolder folder;
  folder.write("fill.comp", kFill);
  folder.write("value.glsl", "float value() { return float(A) + 10.0 * float(B) + 100.0 * float(READ_TEXELS); }\n");
  const LoadPath path = GENERATE(LoadPath::storage, LoadPath::texel);
  ProgramCache programs(folder.path(), path);
  const Program& first = programs.compute("fill.comp", {{"A", "1"}, {"B", "2"}});
  CHECK(first.label() == "fill.comp [A=1 B=2]");
  CHECK(&programs.compute("fill.comp", {{"B", "2"}, {"A", "1"}}) == &first);
  const Program& other = programs.compute("fill.comp", {{"A", "1"}, {"B", "3"}});
  CHECK(&other != &first);
  CHECK(programs.size() == 2);
  const float texels = path == LoadPath::texel ? 100.0f : 0.0f;
  CHECK(filled(first) == 21.0f + texels);
  CHECK(filled(other) == 31.0f + texels);
  CHECK(std::string(name_of(LoadPath::storage)) == "ssbo");
  CHECK(std::string(name_of(LoadPath::texel)) == "texel");
}

TEST_CASE("reload uses new code and keeps the old code if the new one does not compile") {
  const auto context = test::each_context();
  const test::ShaderFolder folder;
  folder.write("fill.comp", kFill);
  folder.write("value.glsl", "float value() { return 1.0; }\n");
  ProgramCache programs(folder.path(), LoadPath::texel);
  const Program& program = programs.compute("fill.comp");
  const Buffer result("result", 4);
  const ComputePass pass(program, {{"result", &result}}, 1);
  const auto value = [&] {
    pass.run();
    return result.read<float>()[0];
  };
  CHECK(value() == 1.0f);
  const unsigned generation = program.generation();

  folder.write("value.glsl", "float value() { return 2.0; }\n");
  CHECK(programs.reload().empty());
  CHECK(program.generation() > generation);
  CHECK(value() == 2.0f);

  folder.write("value.glsl", "\nfloat value() { return nonsense; }\n");
  const std::vector<std::string> messages = programs.reload();
  REQUIRE(messages.size() == 1);
  CHECK_THAT(messages[0], Contains("shaders/value.glsl:2: ") && Contains("nonsense"));
  CHECK(value() == 2.0f);

  std::filesystem::remove(folder.path() / "value.glsl");
  CHECK(programs.reload().size() == 1);
  CHECK(value() == 2.0f);
}

TEST_CASE("a cache that ends leaves no program in use") {
  const auto context = test::each_context();
  const test::ShaderFolder folder;
  folder.write("fill.comp", kFill);
  folder.write("value.glsl", "float value() { return 2.0; }\n");
  const auto in_use = [] {
    GLint id = 0;
    GetIntegerv(GL_CURRENT_PROGRAM, &id);
    return id;
  };
  {
    ProgramCache programs(folder.path(), LoadPath::storage);
    CHECK(filled(programs.compute("fill.comp")) == 2.0f);
    CHECK(in_use() != 0);
  }
  CHECK(in_use() == 0);
}

TEST_CASE("uniforms are set by name and unknown names are ignored") {
  const auto context = test::each_context();
  const test::ShaderFolder folder;
  folder.write("fill.comp", kFill);
  folder.write("value.glsl",
               "uniform float a;\nuniform int b;\nuniform uint c;\nuniform vec4 d;\nuniform mat4 e;\n"
               "float value() { return a + float(b) + float(c) + dot(d, vec4(1, 10, 100, 1000)) + e[3][0]; }\n");
  ProgramCache programs(folder.path(), LoadPath::storage);
  const Program& program = programs.compute("fill.comp");
  float matrix[16] = {};
  matrix[12] = 0.125f;
  program.set("a", 0.5f);
  program.set("b", -3);
  program.set("c", 7u);
  program.set("d", 1, 2, 3, 4);
  program.set_matrix("e", matrix);
  program.set("none", 1.0f);
  CHECK(filled(program) == 0.5f - 3 + 7 + 4321 + 0.125f);
  CHECK(GetError() == GL_NO_ERROR);
}

}  // namespace fascia::gl
