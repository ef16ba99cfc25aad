#include "gl/shader_source.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <regex>
#include <sstream>

#include "base/error.h"

namespace fascia::gl {
namespace {

std::string place(const std::string& file, int line) {
  return "shaders/" + file + (line > 0 ? ":" + std::to_string(line) : "");
}

class Flattener {
 public:
  Flattener(const std::filesystem::path& folder, ShaderText& result, const std::vector<std::string>& included)
      : folder_(folder), result_(result), done_(included) {}

  /// Appends `file` unless it is already included. `from` is the place of the include.
  void append(const std::string& file, const std::string& from) {
    if (std::find(open_.begin(), open_.end(), file) != open_.end()) {
      std::string chain;
      for (const std::string& f : open_) chain += f + " -> ";
      throw Error(from, "circular include: " + chain + file, "expected includes without a circle");
    }
    if (std::find(done_.begin(), done_.end(), file) != done_.end()) return;
    std::ifstream in(folder_ / file);
    std::error_code ec;
    if (!in || !std::filesystem::is_regular_file(folder_ / file, ec))
      throw Error(from, "no shader file " + file, "expected it in " + folder_.string());
    open_.push_back(file);
    std::string line;
    for (int number = 1; std::getline(in, line); ++number) {
      if (!line.empty() && line.back() == '\r') line.pop_back();
      take(line, file, number);
    }
    open_.pop_back();
    done_.push_back(file);
  }

  void emit(const std::string& line, const std::string& file, int number) {
    result_.text += line + "\n";
    result_.lines.push_back({file, number});
  }

 private:
  void take(const std::string& line, const std::string& file, int number) {
    const auto first = line.find_first_not_of(" \t");
    const bool directive = first != std::string::npos && line[first] == '#';
    if (directive) {
      if (line.find("include") == std::string::npos && line.find("version") == std::string::npos)
        return emit(line, file, number);
      static const std::regex include("^\\s*#\\s*include\\b(.*)$"), version("^\\s*#\\s*version\\b.*"),
          quoted("^\\s*\"([^\"]+)\"\\s*(//.*)?$");
      std::smatch match, name;
      if (std::regex_match(line, version))
        throw Error(place(file, number), "has a #version line", "expected none: every program gets #version 430 core");
      if (std::regex_match(line, match, include)) {
        const std::string rest = match[1];
        if (!std::regex_match(rest, name, quoted))
          throw Error(place(file, number), "cannot read '" + line + "'", "expected #include \"folder/file.glsl\"");
        append(std::filesystem::path(name[1].str()).lexically_normal().generic_string(), place(file, number));
        return;
      }
    } else if (line.find("PUT") != std::string::npos || line.find("INOUT") != std::string::npos) {
      declare(line.substr(0, line.find("//")), place(file, number));
    }
    emit(line, file, number);
  }

  void declare(const std::string& code, const std::string& where) {
    static const std::regex declaration(
        "\\b(INPUT_VEC4_IN_PLACE|INPUT_VEC4|INPUT_UVEC4|INPUT_FLOAT|INPUT_UINT|OUTPUT|INOUT|COHERENT)\\s*\\(\\s*([^)]*?"
        ")\\s*"
        "\\)");
    static const std::map<std::string, Texel> kinds = {
        {"INPUT_VEC4", Texel::vec4},   {"INPUT_VEC4_IN_PLACE", Texel::vec4_in_place},
        {"INPUT_UVEC4", Texel::uvec4}, {"INPUT_FLOAT", Texel::float1},
        {"INPUT_UINT", Texel::uint1},  {"OUTPUT", Texel::none},
        {"INOUT", Texel::none},        {"COHERENT", Texel::none}};
    static const std::regex names("(?:(\\w+)\\s*,\\s*)?(\\w+)\\s*,\\s*(\\w+)");  // [type,] Block, name
    for (std::sregex_iterator it(code.begin(), code.end(), declaration), end; it != end; ++it) {
      const std::string macro = (*it)[1], arguments = (*it)[2];
      std::smatch match;
      if (!std::regex_match(arguments, match, names)) continue;  // the compiler reports it better
      const std::string type = match[1], block = match[2], name = match[3];
      if (block != pascal_case(name))
        throw Error(where, macro + " of " + name + " names its block " + block, "expected " + pascal_case(name));
      const auto [known, fresh] = result_.declared.emplace(name, kinds.at(macro));
      if (!fresh && known->second != kinds.at(macro))
        throw Error(where, name + " is declared a second time, as another kind of buffer",
                    "expected one kind for one name");
      if (!type.empty()) result_.output_types.emplace(name, type);
    }
  }

  const std::filesystem::path& folder_;
  ShaderText& result_;
  std::vector<std::string> open_, done_;
};

}  // namespace

std::string pascal_case(const std::string& snake_case) {
  std::string result;
  bool upper = true;
  for (const char c : snake_case) {
    if (c == '_') {
      upper = true;
      continue;
    }
    result += upper ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    upper = false;
  }
  return result;
}

ShaderText read_shader(const std::filesystem::path& folder, const std::string& file, const Defines& defines,
                       const std::vector<std::string>& included) {
  ShaderText result;
  Flattener flattener(folder, result, included);
  flattener.emit("#version 430 core", file, 0);
  for (const auto& [name, value] : defines) flattener.emit("#define " + name + " " + value, file, 0);
  flattener.append(file, place(file, 0));
  return result;
}

std::string map_log(const ShaderText& source, const std::string& log) {
  // Mesa "0:12(3): ", NVIDIA "0(12) : ", others "ERROR: 0:12: ".
  static const std::regex position("^(?:ERROR: |WARNING: )?0(?::(\\d+)(?:\\(\\d+\\))?|\\((\\d+)\\)) ?: ?");
  std::istringstream in(log);
  std::string result, line;
  while (std::getline(in, line)) {
    std::smatch match;
    if (std::regex_search(line, match, position)) {
      const std::string digits = match[1].matched ? match[1] : match[2];
      const std::size_t flat = digits.size() < 9 ? std::stoul(digits) : 0;
      if (flat >= 1 && flat <= source.lines.size()) {
        const ShaderText::Line& at = source.lines[flat - 1];
        line = place(at.file, at.line) + ": " + match.suffix().str();
      }
    }
    result += line + "\n";
  }
  return result;
}

}  // namespace fascia::gl
