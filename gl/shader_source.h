// Reads shader text from disk: #include "..." (relative to the shader folder, each file once), #define lines for a
// variant, and a map from flat line numbers back to files, since drivers ignore the source number of #line. Independent
// of OpenGL.
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace fascia::gl {

using Defines = std::vector<std::pair<std::string, std::string>>;  // NAME, value; sorted by the cache

/// The type of an input's texel, from its declaration by INPUT_VEC4, INPUT_UVEC4, INPUT_FLOAT or INPUT_UINT; none for
/// outputs. vec4_in_place (INPUT_VEC4_IN_PLACE): a vec4 of a buffer that the dispatch also writes, under another name.
enum class Texel { none, vec4, vec4_in_place, uvec4, float1, uint1 };

struct ShaderText {
  // "#version 430 core", the defines, then the flattened file (which must not have its own #version line)
  std::string text;
  struct Line {
    std::string file;  // relative to the shader folder: "sim/step/predict.comp"
    int line;
  };
  std::vector<Line> lines;  // [flat line - 1]
  // Buffers declared with the macros of common/io.glsl, by their second name. The declarations are read here because
  // reflection distinguishes neither a float texel from a vec4 texel nor inputs that the driver optimized away.
  std::map<std::string, Texel> declared;
  std::map<std::string, std::string> output_types;  // of an element: "vec4", "uint"
};

/// "slot_begin" to "SlotBegin": the block name of a buffer.
std::string pascal_case(const std::string& snake_case);

/// Throws Error "shaders/sim/x.comp:3: ..." for a missing file, a circular include, or a declaration with inconsistent
/// names. Files in `included` are not included again.
ShaderText read_shader(const std::filesystem::path& folder, const std::string& file, const Defines& defines,
                       const std::vector<std::string>& included = {});

/// A driver's log with every "0:12(3):" or "0(12) :" or "ERROR: 0:12:" replaced by "shaders/sim/x.comp:12:".
std::string map_log(const ShaderText& source, const std::string& log);

}  // namespace fascia::gl
