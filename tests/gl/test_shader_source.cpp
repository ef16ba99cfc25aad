#include "gl/shader_source.h"

#include "tests/gl/gl_support.h"

namespace fascia::gl {
namespace {

using Catch::Matchers::Contains;
using Catch::Matchers::Equals;
using test::error_of;

std::string place_of(const ShaderText& source, const std::string& text) {
  std::istringstream in(source.text);
  std::string line;
  for (std::size_t i = 0; std::getline(in, line); ++i)
    if (line == text) return source.lines[i].file + ":" + std::to_string(source.lines[i].line);
  return "not there";
}

}  // namespace

TEST_CASE("includes are flattened once each and every line has its origin") {
  const test::TemporaryFolder folder;
  std::filesystem::create_directory(folder / "common");
  std::ofstream(folder / "common/a.glsl") << "float a;\n";
  std::ofstream(folder / "common/b.glsl") << "// b\n#include \"common/a.glsl\"\nfloat b;\n";
  std::ofstream(folder / "x.comp")
      << "// x\r\n#include \"common/b.glsl\"\r\n  #  include \"common/./a.glsl\" // again\nfloat x;";
  const ShaderText source = read_shader(folder.path(), "x.comp", {{"FEATURE", "1"}, {"SIZE", "32"}});
  CHECK(source.text ==
        "#version 430 core\n#define FEATURE 1\n#define SIZE 32\n// x\n// b\nfloat a;\nfloat b;\nfloat x;\n");
  CHECK(source.lines.size() == 8);
  CHECK(place_of(source, "float a;") == "common/a.glsl:1");
  CHECK(place_of(source, "float b;") == "common/b.glsl:3");
  CHECK(place_of(source, "float x;") == "x.comp:4");
}

TEST_CASE("errors in shader text name file and line") {
  const test::TemporaryFolder folder;
  const auto write = [&](const std::string& name, const std::string& text) { std::ofstream(folder / name) << text; };
  const auto message = [&](const std::string& name) { return error_of([&] { read_shader(folder.path(), name, {}); }); };
  CHECK_THAT(message("none.comp"),
             Equals("shaders/none.comp: no shader file none.comp; expected it in " + folder.path().string()));
  write("missing.comp", "// one\n#include \"gone.glsl\"\n");
  CHECK_THAT(message("missing.comp"), Contains("shaders/missing.comp:2: no shader file gone.glsl"));
  write("folder.comp", "#include \".\"\n");
  CHECK_THAT(message("folder.comp"), Contains("shaders/folder.comp:1: no shader file"));
  write("p.glsl", "#include \"q.glsl\"\n");
  write("q.glsl", "\n\n#include \"p.glsl\"\n");
  write("circle.comp", "#include \"p.glsl\"\n");
  CHECK_THAT(message("circle.comp"),
             Contains("shaders/q.glsl:3: circular include: circle.comp -> p.glsl -> q.glsl -> p.glsl"));
  write("version.comp", "\n#version 450\n");
  CHECK_THAT(message("version.comp"), Contains("shaders/version.comp:2: has a #version line"));
  write("angle.comp", "#include <common.glsl>\n");
  CHECK_THAT(message("angle.comp"), Contains("shaders/angle.comp:1: cannot read"));
  write("name.comp", "INPUT_VEC4(Positions, position)\n");
  CHECK_THAT(message("name.comp"),
             Contains("shaders/name.comp:1: INPUT_VEC4 of position names its block Positions; expected Position"));
  write("twice.comp", "INPUT_UINT(Slot, slot)\nINPUT_FLOAT(Slot, slot)\n");
  CHECK_THAT(message("twice.comp"), Contains("shaders/twice.comp:2: slot is declared a second time"));
}

TEST_CASE("declarations of buffers are collected") {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "x.comp") << "#define INPUT_VEC4(Block, name) nothing\n// INPUT_VEC4(Comment, comment)\n"
                                      "INPUT_VEC4(Rest, rest) INPUT_UVEC4( Corner , corner )\n"
                                      "#if DAMPING\nINPUT_FLOAT(Damping, damping)\n#endif\n"
                                      "INPUT_UINT(SlotBegin, slot_begin)  // INPUT_UINT(Other, other)\n"
                                      "OUTPUT(vec4, Result, result)\nINOUT(uint, Visit, visit)\n";
  const std::map<std::string, Texel> expected = {{"rest", Texel::vec4},      {"corner", Texel::uvec4},
                                                 {"damping", Texel::float1}, {"slot_begin", Texel::uint1},
                                                 {"result", Texel::none},    {"visit", Texel::none}};
  CHECK(read_shader(folder.path(), "x.comp", {}).declared == expected);
}

TEST_CASE("block names are the buffer names in Pascal case") {
  CHECK(pascal_case("slot_begin") == "SlotBegin");
  CHECK(pascal_case("rest") == "Rest");
  CHECK(pascal_case("inv_dm_0") == "InvDm0");
}

TEST_CASE("driver logs are mapped to files") {
  ShaderText source;
  source.lines = {{"x.comp", 0}, {"x.comp", 1}, {"common/a.glsl", 7}};
  CHECK(map_log(source, "0:3(12): error: `foo' undeclared\n") ==
        "shaders/common/a.glsl:7: error: `foo' undeclared\n");                                                // Mesa
  CHECK(map_log(source, "0(2) : error C1503: undefined\n") == "shaders/x.comp:1: error C1503: undefined\n");  // NVIDIA
  CHECK(map_log(source, "ERROR: 0:3: 'foo' : undeclared") ==
        "shaders/common/a.glsl:7: 'foo' : undeclared\n");  // others
  CHECK(map_log(source, "0:1(1): warning: w\n") == "shaders/x.comp: warning: w\n");
  for (const std::string strange :
       {"0:99(1): beyond\n", "0:99999999999999999999(1): far beyond\n", "0:0(1): before\n", "link failed\n"})
    CHECK(map_log(source, strange) == strange);
}

}  // namespace fascia::gl
